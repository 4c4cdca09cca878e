#!/usr/bin/env bash
# Public campaigns: downloads their files (or takes them from $REAL_SOURCE), checks size and SHA-256, runs them and prints etalon's
# figures beside the published ones. files.tsv states where each file comes from; README.md the licences and citations.
# Exit code: 0 done, 1 a published figure is not reproduced or the network cannot be reached, 2 a file has changed.
set -euo pipefail
etalon=$(realpath "$1") folder=$2
here=$(cd "$(dirname "$0")" && pwd)
samples=$here/../../samples
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

fetch() { # PATH BYTES SHA256 ADDRESS
    local to=$folder/$1
    [ -f "$to" ] && sha256sum --quiet --check <<<"$3  $to" 2>/dev/null && return
    mkdir -p "$(dirname "$to")"
    if [ -n "${REAL_SOURCE:-}" ]; then
        [ -f "$REAL_SOURCE/$1" ] || { echo "error: $REAL_SOURCE/$1 is missing"; exit 2; }
        cp -- "$REAL_SOURCE/$1" "$to.part"
    elif ! curl --fail --silent --show-error --location --max-time 60 --output "$to.part" "$4"; then
        echo "error: $4 cannot be downloaded: no network, or the address has changed"
        echo "hint: state a folder that contains the files: make real REAL_SOURCE=FOLDER"
        exit 1
    fi
    if ! sha256sum --quiet --check <<<"$3  $to.part" 2>/dev/null; then
        echo "error: $1: SHA-256 differs from the one in tests/real/files.tsv (expected $2 bytes, found $(stat -c %s "$to.part"))"
        rm -f "$to.part"
        exit 2
    fi
    chmod u+w "$to.part"
    mv "$to.part" "$to"
}

while IFS=$'\t' read -r path bytes sum address; do
    [ "$path" = path ] || fetch "$path" "$bytes" "$sum" "$address"
done <"$here/files.tsv"
export ETALON_REFERENCE=$folder

wrong=0
row() { printf '%-34s %-38s %12s %12s  %s\n' "$@"; }
row campaign figure published etalon source

# ABB IRB 120: no result is published with the data; the figures are those of an independent fit with SciPy on another half of the poses
rm -rf "$folder/abb-irb120"
cp -r "$samples/abb-irb120" "$folder/abb-irb120"
rm -rf "$folder/abb-irb120/out"
"$etalon" run "$folder/abb-irb120" >"$folder/abb-irb120.txt" 2>"$folder/abb-irb120.log" || [ $? = 1 ]
# lines of stdout: `position  mm  0.697  0.818  1.466  3.179  0.121  0.137  0.242  0.386  6.0` of the validation poses
read -r -a found < <(awk '/^validation:/ { there = 1 } there && $1 == "position" { print; exit }' "$folder/abb-irb120.txt")
for figure in "mean error before 2 0.731" "RMS error before 3 0.874" "95 % error before 4 1.554" "mean error after 6 0.123" \
    "RMS error after 7 0.140" "95 % error after 8 0.250" "largest error after 9 0.425"; do
    read -r -a words <<<"$figure"
    n=${#words[@]}
    row "ABB IRB 120 (validation)" "${words[*]:0:n-2}, mm" "${words[n-1]}" "${found[${words[n-2]}]}" "SciPy, 491 other poses"
done

# KIT: three reflectors, ten visits; printed by the authors to 0.1 um
for series in pose1 pose2 anfahrt_pose1; do
    # the number of the reflector stands for the pose, the visits are counted in the order of measurement
    "$etalon" iso9283 pose "$folder/robots/kit_iso9283_tracker/tracker/$series.txt" --json --no-header --column pose=1 \
        --column x_mm=2 --column y_mm=3 --column z_mm=4 --constant cycle=visit >"$folder/$series.json" 2>"$folder/$series.log"
    for target in 1 2 3; do
        published=$(awk -v t="$target" '$1 == "Pos." && $3 == "targ." && $4 == t { print $6 }' "$folder/robots/kit_iso9283_tracker/results/${series}_results.txt")
        found=$(awk -v t="$target" '/"rp_mm":/ && ++n == t { gsub(/[^0-9.e-]/, "", $2); printf "%.4f", $2; exit }' "$folder/$series.json")
        row "KIT, $series" "RP of reflector $target, mm" "$published" "$found" "authors' printed results"
        [ "$published" = "$found" ] || wrong=1
    done
done
[ "$wrong" = 0 ] || { echo "error: a published figure is not reproduced to its last printed digit"; exit 1; }
echo "reports: $folder/abb-irb120/out/report.html"
