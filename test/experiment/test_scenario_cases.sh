#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Files that users of like programs have stumbled over: what smore_experiment --validate says of each.
# usage: test_scenario_cases.sh PROGRAM CASES
set -uo pipefail
program=$1
cases=$2
said=$(mktemp)
trap 'rm -f "$said"' EXIT
failures=0

# expect CODE FILE WORDS...: the check ends with CODE and says all WORDS, in one line where it refuses.
expect() {
  local code=$1 file=$2
  shift 2
  "$program" --scenario "$cases/$file" --validate 2>"$said"
  local actual=$? wrong=
  [ "$actual" -eq "$code" ] || wrong="exit $actual, not $code"
  [ "$(wc -l <"$said")" -eq 1 ] || wrong="not one line"
  for words in "$@"; do
    grep -qF -- "$words" "$said" || wrong="no '$words'"
  done
  if [ -n "$wrong" ]; then
    echo "$file: $wrong in:"
    cat "$said"
    failures=$((failures + 1))
  fi
}

expect 0 convex_mesh/scene_box_rotated_blender6_obj.yaml valid
expect 0 convex_mesh/scene_box_straight_blender6_obj.yaml valid
expect 0 ngon/u_plate.yaml valid
expect 0 ngon/u_plate_from_notch.yaml valid
expect 0 ngon/u_plate_triangulated.yaml valid
expect 0 ngon/u_object.yaml "u_plate.obj moves as 3 convex parts" "up to 0.0 mm off"
for file in near far object; do
  expect 2 "millimetres/mm_$file.yaml" "looks like millimetres; scale: [0.001, 0.001, 0.001]"
done
expect 2 duplicate_key/dup.yaml "line 14" "'goal' is given twice"
expect 2 duplicate_key/dup_contact.yaml "'contact_force' is given twice"
expect 2 duplicate_key/second_document.yaml "line 4" "a second document"
expect 0 numbers/sci.yaml valid
expect 0 numbers/neg.yaml valid
expect 2 encoding/latin1.yaml "line 1: not UTF-8 (byte 252); save the file as UTF-8"
expect 2 encoding/utf16.yaml "UTF-16; save the file as UTF-8"
expect 0 encoding/utf8.yaml valid
expect 0 encoding/bom_crlf.yaml valid
expect 2 degrees/degrees.yaml "goal.rpy: '90' is beyond 2 pi; angles are in radians; 90 looks like degrees"
expect 2 far/far.yaml "voxels of 0.002 m" "from -64.536 to 64.536 m"
expect 0 floor/floor_30.yaml valid
expect 0 floor/nofloor.yaml valid
expect 0 names/007.yaml valid
expect 0 names/2024_05_01.yaml valid
expect 2 names "is a directory"
[ "$failures" -eq 0 ]
