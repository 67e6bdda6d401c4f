#!/usr/bin/env bash
# Exit codes and messages of smore_experiment, as a user meets them.
# usage: test_experiment_program.sh PROGRAM SCENARIO_DIRECTORY
set -uo pipefail
program=$1
scenarios=$2
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
failures=0

# expect CODE WORDS ARGUMENTS...: the program ends with CODE and says WORDS on standard error.
expect() {
  local code=$1 words=$2
  shift 2
  "$program" "$@" >"$directory/out" 2>"$directory/err"
  local actual=$?
  if [ "$actual" -ne "$code" ] || ! grep -qF -- "$words" "$directory/err"; then
    echo "smore_experiment $*: exit $actual, expected $code and '$words' in:"
    cat "$directory/err"
    failures=$((failures + 1))
  fi
}

reference=$scenarios/s_shape_two_pegs.yaml
expect 2 "--scenario is required"
expect 2 "--trials" --scenario "$reference" --trials 0
expect 2 "--method" --scenario "$reference" --method guess
expect 2 "/nowhere.yaml: cannot be read" --scenario /nowhere.yaml
sed 's/voxel_size: 0.03/voxel_size: -1/; s/task:/tusk:/' "$reference" >"$directory/bad.yaml"
expect 2 "voxel_size" --scenario "$directory/bad.yaml"
expect 2 "tusk: unknown key" --scenario "$directory/bad.yaml"
sed 's/start: {position: \[0, 0, 0\]/start: {position: [0.15, 0, 0]/' "$reference" >"$directory/touching.yaml"
expect 2 "start" --scenario "$directory/touching.yaml" --validate
expect 0 "valid" --scenario "$reference" --validate
echo 'belief: {radios: 0.02}' >"$directory/parameters.yaml"
expect 2 "belief.radios: unknown key" --scenario "$reference" --parameters "$directory/parameters.yaml"
expect 2 "only the method smore" --scenario "$reference" --method paper \
  --parameters "$directory/parameters.yaml"
expect 1 "cannot be written" --scenario "$reference" --output /nowhere/result.json
expect 0 "limit of 2 collisions" --scenario "$reference" --method paper --max-collisions 2 \
  --output "$directory/result.json" --maps "$directory/maps"
for file in result.json maps/world.ot maps/object.ot; do
  if [ ! -s "$directory/$file" ]; then
    echo "no $file was written"
    failures=$((failures + 1))
  fi
done
[ "$failures" -eq 0 ]
