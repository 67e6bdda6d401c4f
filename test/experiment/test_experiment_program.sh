#!/usr/bin/env bash
# Exit codes and messages of smore_experiment, smore_rebuild and smore_score, as a user meets them.
# usage: test_experiment_program.sh SMORE_EXPERIMENT SMORE_REBUILD SMORE_SCORE SCENARIO_DIRECTORY
set -uo pipefail
program=$1
scenarios=$4
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
failures=0

# expect CODE WORDS ARGUMENTS...: the program ends with CODE and says WORDS, if any, on standard error.
expect() {
  local code=$1 words=$2
  shift 2
  "$program" "$@" >"$directory/out" 2>"$directory/err"
  local actual=$?
  if [ "$actual" -ne "$code" ] || { [ -n "$words" ] && ! grep -qF -- "$words" "$directory/err"; }; then
    echo "$(basename "$program") $*: exit $actual, expected $code and '$words' in:"
    cat "$directory/err"
    failures=$((failures + 1))
  fi
}

reference=$scenarios/s_shape_two_pegs.yaml
expect 2 "--scenario is required"
expect 2 "--trials" --scenario "$reference" --trials 0
expect 2 "--method" --scenario "$reference" --method guess
expect 2 "--informed-touches: only the method smore" --scenario "$reference" --method paper --informed-touches
expect 2 "give one of them" --scenario "$reference" --informed-touches --random-touches
expect 2 "give --touches-after-success" --scenario "$reference" --random-touches
expect 2 "--maps: is empty" --scenario "$reference" --maps ""
expect 2 "scenario '/nowhere.yaml': there is no readable file" --scenario /nowhere.yaml
expect 2 "one of: c_on_peg, chair" --scenario nowhere
expect 0 "/one_peg.yaml: valid" --scenario one_peg --validate
cp "$scenarios/one_peg.yaml" "$directory/own.yaml"
expect 1 "is read as well" --scenario "$directory/own.yaml" --output "$directory/own.yaml"
expect 1 "is read as well" --scenario "$directory/own.yaml" --validate --output "$directory/own.yaml"
cmp -s "$scenarios/one_peg.yaml" "$directory/own.yaml" || { echo "the scenario was written over"; failures=1; }
expect 1 "the name of recorded evidence" --scenario one_peg --output "$directory/seed_1.evidence"
sed 's/voxel_size: 0.03/voxel_size: -1/; s/task:/tusk:/' "$reference" >"$directory/bad.yaml"
expect 2 "voxel_size" --scenario "$directory/bad.yaml"
expect 2 "tusk: unknown key" --scenario "$directory/bad.yaml"
sed 's/start: {position: \[0, 0, 0\]/start: {position: [0.15, 0, 0]/' "$reference" >"$directory/touching.yaml"
expect 2 "start" --scenario "$directory/touching.yaml" --validate
expect 0 "valid" --scenario "$reference" --validate
task=$scenarios/../tasks/ur5e.yaml
expect 0 "valid, a task for a real robot" --scenario "$task" --validate
expect 2 "object, environment: missing; without shapes it is a task" --scenario "$task"
echo 'belief: {radios: 0.02}' >"$directory/parameters.yaml"
echo 'belief: {}' >"$directory/no_parameters.yaml"
expect 2 "belief.radios: unknown key" --scenario "$reference" --parameters "$directory/parameters.yaml"
expect 2 "the method cspace has no parameters" --scenario "$reference" --method cspace \
  --parameters "$directory/parameters.yaml"
printf 'motions:\n- poses: [{position: [9, 0, 0]}]\n- {poses: []}\n' >"$directory/touches.yaml"
expect 2 "is outside of the workspace" --scenario chair --touch-poses "$directory/touches.yaml"
expect 2 "poses" --scenario chair --touch-poses "$directory/touches.yaml"
expect 2 "give one of them" --scenario chair --random-touches --touch-poses "$directory/touches.yaml"
expect 1 "cannot be written" --scenario "$reference" --output /proc/nowhere/result.json
expect 1 "/proc/evidence: cannot be made" --scenario "$reference" --record /proc/evidence
expect 1 "result.json: cannot be made" --scenario "$reference" \
  --record "$directory/bad.yaml/result.json"
# What fails at the end only, as a full disk does, loses nothing.
expect 1 "the results are on standard output" --scenario "$reference" --method paper --max-collisions 1 \
  --output /dev/full
if ! grep -q '"collisions": 1,' "$directory/out"; then
  echo "the results of a file that cannot be written are lost"
  failures=$((failures + 1))
fi
expect 0 "limit of 2 collisions" --scenario "$reference" --method paper --max-collisions 2 \
  --output "$directory/made/result.json" --maps "$directory/maps" --record "$directory/new/record"
printf 'prior: {world: [{source: maps/world.ot}]}\n' | cat "$scenarios/one_peg.yaml" - >"$directory/told.yaml"
expect 1 "world.ot: is read as well" --scenario "$directory/told.yaml" --output "$directory/maps/world.ot"
expect 1 "world.ot is read as well" --scenario "$directory/told.yaml" --maps "$directory/maps"
expect 0 "valid" --scenario "$directory/told.yaml" --validate --maps "$directory"

program=$2
evidence=$directory/new/record/seed_1.evidence
expect 2 "either --evidence or --bag" --output "$directory/again"
expect 2 "--output is required" --evidence "$evidence"
expect 2 "--method" --evidence "$evidence" --output "$directory/again" --method guess
expect 2 "--voxel-size" --evidence "$evidence" --output "$directory/again" --voxel-size -1
expect 2 "/nowhere: cannot be read" --evidence /nowhere --output "$directory/again"
expect 2 "not a record" --evidence "$reference" --output "$directory/again"
expect 2 "the method cspace has no parameters" --evidence "$evidence" --output "$directory/again" --method cspace \
  --parameters "$directory/no_parameters.yaml"
expect 2 "belief.radios: unknown key" --evidence "$evidence" --output "$directory/again" \
  --parameters "$directory/parameters.yaml"
expect 1 "cannot be made" --evidence "$evidence" --output /proc/maps_of_evidence
head -c 300 "$evidence" >"$directory/short.evidence"
expect 2 "before its header, task and method are whole" --evidence "$directory/short.evidence" \
  --output "$directory/again"
head -c -10 "$evidence" >"$directory/cut.evidence"
expect 0 "the last record was cut" --evidence "$directory/cut.evidence" --output "$directory/cut"
expect 0 "" --evidence "$evidence" --output "$directory/again/deep"
expect 0 "" --evidence "$evidence" --output "$directory/smore" --method smore --voxel-size 0.05 \
  --parameters "$directory/no_parameters.yaml"
for map in world.ot object.ot; do
  if ! cmp "$directory/maps/$map" "$directory/again/deep/$map"; then
    echo "$map differs from the trial's"
    failures=$((failures + 1))
  fi
done
for file in made/result.json maps/world.ot maps/object.ot again/deep/summary.json cut/world.ot smore/object.ot; do
  if [ ! -s "$directory/$file" ]; then
    echo "no $file was written"
    failures=$((failures + 1))
  fi
done

program=$3
expect 2 "evidence is required"
expect 2 "/nowhere: cannot be read" /nowhere
expect 2 "not a record" "$reference"
expect 1 "cannot be written" --output /proc/nowhere/scores.json "$evidence"
cp "$evidence" "$directory/copy.jsonl"
expect 1 "is read as well" --output "$directory/copy.jsonl" "$directory/copy.jsonl"
expect 2 "belief.radios: unknown key" --parameters "$directory/parameters.yaml" "$evidence"
grep -v '"truth"' "$evidence" >"$directory/live.evidence"
expect 2 "holds no true solids" "$directory/live.evidence"
expect 0 "seed_1.evidence" --quick --output "$directory/scores.json" "$evidence" "$directory/cut.evidence"
if ! /usr/bin/python3 "$scenarios/../../python/table_of_scores.py" "$directory/scores.json" |
  grep '^| s_shape_two_pegs | 2 | 4 of 4 |' >"$directory/row"; then
  echo "the table of scores does not tell the scene, its trials and touches"
  failures=$((failures + 1))
fi
[ "$failures" -eq 0 ]
