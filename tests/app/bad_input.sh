#!/usr/bin/env bash
# Recordings and ships that are no sensible input, through the commands of the program: one line and exit code 1, or an answer
# without a number that is none (docs/bad_input.md).
#   bad_input.sh SWAYAW FOLDER_OF_SHIPS SCRATCH
set -uo pipefail
export LC_ALL=C
swayaw=$1 ships=$2 scratch=$3
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch" || exit 1
ship=$ships/kvlcc2_l7.toml
seconds=20  # of processor time; every one of these answers within one
failed=0

# Exit code 0 and finite output, or 1 and one line that says something.
expect() {  # words of the command
  local code out
  (ulimit -t $seconds && exec "$swayaw" "$@") >out.txt 2>err.txt </dev/null
  code=$?
  out=$(grep -m1 -iwoE '[-+]?(nan|inf|infinity)' out.txt)
  if [ $code -eq 0 ] && [ -z "$out" ]; then return; fi
  # before the line that refuses there may be others, which warn; each of a commands' few begins with its name or a file
  if [ $code -eq 1 ] && [ ! -s out.txt ] && [ -s err.txt ] && [ "$(wc -l <err.txt)" -le 3 ] &&
    ! grep -vqE '^(swayaw: |[a-z_]+\.(csv|toml):)' err.txt; then return; fi
  echo "swayaw $*: exit code $code${out:+, \"$out\" in the output}"
  sed 's/^/    /' err.txt | head -3
  failed=1
}

header='time_s,x_m,y_m,psi_rad,u_m_s,v_m_s,r_rad_s,delta_rad,rev_s'
rows() {  # awk expressions of the columns
  awk -v OFS=, "BEGIN { for (i = 0; i < 60; ++i) print $1 }"
}
steady='i, i, 0, 0, 1.2, 0, 0, 0, 10.4'
{ echo "$header"; } >no_samples.csv
{ echo "$header"; echo '0,0,0,0,1.2,0,0,0.1,10.4'; } >one_sample.csv
{ echo "$header"; echo '0,0,0,0,1.2,0,0,0.1,10.4'; echo '1,1,0,0,1.2,0,0,0.1,10.4'; } >two_samples.csv
: >empty.csv
{ echo "$header"; rows "$steady" | sed '20s/1.2/inf/'; } >infinite.csv
{ echo "$header"; rows "$steady" | sed '20s/1.2/nan/;21s/1.2//'; } >missing.csv
{ echo "$header"; rows '"1e-310", 0, 0, 0, 1.2, 0, 0, 0, 10.4' | head -1; rows 'i + 1, "5e-324", "-0.0", "1e-310", 1.2, "5e-324", "1e-320", "1e-315", 10.4'; } >denormal.csv
{ echo "$header"; rows 'i, "1e300", "-1e300", "1e200", "1e300", 0, "1e300", "1e300", "1e300"'; } >huge.csv
{ echo "$header"; rows 'i, 1e6 * i, 0, 57.3 * i, 1200, 0, 57.3, 10 * (i % 20 < 10 ? 1 : -1), 600'; } >wrong_units.csv
{ echo "$header"; rows '1e9 * i, i, 0, 0, 1.2, 0, 0, 0.1, 10.4'; } >years_apart.csv
{ echo "$header"; rows '1e-9 * i, i, 0, 0, 1.2, 0, 0, 0.1, 10.4'; } >nanoseconds.csv
{ echo "$header"; rows "$steady"; } >still_rudder.csv

for run in no_samples one_sample two_samples empty infinite missing denormal huge wrong_units years_apart nanoseconds still_rudder; do
  expect check --json $run.csv
  expect compare --json "$ship" $run.csv
  expect replay "$ship" $run.csv --out replayed.csv
  expect replay "$ship" $run.csv --forces --out forces.csv
  expect trial --json $run.csv
  expect identify --json --ship "$ship" --model mmg --find N_v --prior $run.csv
  expect diagnose --json "$ship" $run.csv
  expect import $run.csv --out imported.csv
  for made in replayed.csv forces.csv imported.csv; do
    [ -f $made ] && grep -iwqE 'nan|inf' <(grep -v '^#' $made) && { echo "$made of $run.csv holds a number that is none"; failed=1; }
    rm -f $made
  done
done

# the one number of the file replaced
with() {  # key value
  sed "s/^$1 *=.*/$1 = $2/" "$ship" >ship.toml
  cmp -s ship.toml "$ship" && { echo "there is no $1 in $ship"; failed=1; }
}
for change in 'length_m 5e-324' 'length_m 1e300' 'length_m nan' 'length_m inf' 'service_speed_m_s 1e-300' 'service_speed_m_s 1e200' \
  'displacement_m3 1e-320' 'displacement_m3 1e300' 'N_r 1e3' 'N_r 1e300' 'Y_v 1e6' 'm_y -1e3' 'J_z -1e3' 'area_m2 1e12' 'diameter_m 1e-300'; do
  # shellcheck disable=SC2086
  with $change
  expect simulate ship.toml --zigzag 10/10 --json
  expect simulate ship.toml --turn 35 --json
  expect indices ship.toml --json
  expect linearize ship.toml --json
done
exit $failed
