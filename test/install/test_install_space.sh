#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What is installed is complete: definitions, programs, tools, libraries with all that their headers need, and a
# retrieval from it.
# usage: test_install_space.sh BUILD_FOLDER SOURCE_FOLDER INSTALL_PREFIX
set -euo pipefail
build=$1
source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/root$3

fail() {
  echo "install space: $*" >&2
  exit 1
}

# catkin's setup files go to the prefix that was configured, whatever --prefix says.
DESTDIR=$scratch/root cmake --install "$build" >"$scratch/install.log" || fail "$(cat "$scratch/install.log")"

# The build's own environment must not help.
unset CMAKE_PREFIX_PATH LD_LIBRARY_PATH PKG_CONFIG_PATH PYTHONPATH ROS_PACKAGE_PATH
set +u # catkin's setup reads variables that may not be set
source "$prefix/setup.bash"
set -u

[ "$(rospack find smore)" = "$prefix/share/smore" ] || fail "rospack finds smore in $(rospack find smore)"
rosmsg show smore/ContactObservation >/dev/null || fail "rosmsg does not know smore/ContactObservation"
[[ $(rossrv show smore/TwinMaps) == *"octomap_msgs/Octomap world"* ]] || fail "rossrv does not know smore/TwinMaps"
/usr/bin/python3 -c "import smore.msg, smore.srv; assert smore.__file__.startswith('$prefix')" ||
  fail "Python takes the messages from elsewhere"

generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$build/CMakeCache.txt") # what this system has
cmake -G "$generator" -S "$source/test/install/consumer" -B "$scratch/consumer" >"$scratch/consumer.log" &&
  cmake --build "$scratch/consumer" >>"$scratch/consumer.log" 2>&1 || fail "$(cat "$scratch/consumer.log")"
"$scratch/consumer/consumer" >"$scratch/scenarios" || fail "a program that uses the libraries ends with an error"
[ "$(cat "$scratch/scenarios")" = "$prefix/share/smore/config/scenarios" ] ||
  fail "the libraries read the scenarios of $(cat "$scratch/scenarios")"

cmake -G "$generator" -S "$source/examples" -B "$scratch/examples" >"$scratch/examples.log" &&
  cmake --build "$scratch/examples" >>"$scratch/examples.log" 2>&1 || fail "$(cat "$scratch/examples.log")"
"$prefix/lib/smore/smore_experiment" --scenario one_peg --trials 1 --seed 1 --record "$scratch/evidence" \
  --output "$scratch/trial.json" >"$scratch/trial.log" 2>&1 || fail "$(cat "$scratch/trial.log")"
says() { # says WORDS EXAMPLE [ARGUMENT ...]
  "$scratch/examples/${@:2}" >"$scratch/said" 2>&1 || fail "example ${*:2}: $(cat "$scratch/said")"
  grep -q "$1" "$scratch/said" || fail "example ${*:2} does not say '$1': $(cat "$scratch/said")"
}
says "after touch 5: matter at the peg" belief_from_touches
says "the object is at the goal after [1-9]" own_robot
says "touches with probability" plan_and_risk
says "voxels of the world and" replay_run "$scratch/evidence/seed_1.evidence"

if compgen -G "$build/devel/lib/smore/smore_simulator*.so" >/dev/null; then # where pybind11 is
  (cd "$prefix/share/smore/python/smore_gym" &&
    PYTHONPATH=.. /usr/bin/python3 -c 'import simulator; print(simulator.SteppedTrial("one_peg", 1).dimensions)') >"$scratch/said" 2>&1
  [ "$(cat "$scratch/said")" = 3 ] || fail "the installed simulator does not run in Python: $(cat "$scratch/said")"
fi

port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://localhost:$port
"$source/scripts/run_with_limit.py" 300 roslaunch -p "$port" smore retrieval.launch \
  scenario:=one_peg rviz:=false "output:=$scratch/output" >"$scratch/launch.log" 2>&1 || true
grep -q '"success": true' "$scratch/output/summary.json" || fail "$(tail -n 40 "$scratch/launch.log")"
"$prefix/share/smore/python/plot_maps.py" --scenario one_peg --maps "$scratch/output" \
  --path "$scratch/output/summary.json" >/dev/null || fail "the installed tools draw no picture"
[ -s "$scratch/output/maps.png" ] || fail "the installed tools write no picture"
