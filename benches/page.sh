#!/bin/bash
# Writes benches/README.md: what `make bench` measures here, and what was measured before on its own (measured.md).
set -euo pipefail
cd "$(dirname "$0")/.."
new=$(mktemp)
trap 'rm -f "$new"' EXIT
python=${PYTHON:-python3}
measure() {
    printf '\n## %s\n\n%s\n\n```text\n' "$1" "$2"
    cargo bench --quiet --locked --bench "$3" 2>/dev/null
    printf '```\n'
}
{
    printf '# Benchmarks\n\nWritten by `make bench`; a factor below 1 means that the peer is faster.\n\n'
    printf -- '- Machine: %s, %s cores, %s, load %s at the start.\n' "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1)" \
        "$(nproc)" "$(uname -sr)" "$(cut -d' ' -f1 /proc/loadavg)"
    printf -- '- Versions: etalon %s (%s), %s; %s.\n' "$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -1)" \
        "$(git rev-parse --short HEAD)" "$(rustc --version)" \
        "$("$python" -c 'import sys, numpy, scipy; print("Python", sys.version.split()[0] + ", NumPy", numpy.__version__ + ", SciPy", scipy.__version__)' 2>/dev/null || echo 'SciPy is not there: left out')$("$python" -c 'import pinocchio; print(", Pinocchio", pinocchio.__version__, end="")' 2>/dev/null)"
    printf -- '- Command: `%smake bench`\n' "${COUNT:+COUNT=$COUNT }"
    measure 'Many campaigns, and start-up' "$(<benches/batch.md)" batch
    measure 'Identification' 'IRB 120, 688 poses, 45 and 39 parameters: SciPy'"'"'s whole job, and its last fit alone.' identify
    measure 'Choice of poses' '15 of the 130 candidates of the sample dextar, for O1; NumPy does one decomposition a candidate.' plan
    measure 'Arms' "$(<benches/arms.md)" arms
    measure 'Draws of whole campaigns' "$(<benches/uncertainty.md)" uncertainty
    measure 'Growth' '20 targets a pose: four times as many readings of four times as many targets, compared with the first.' scale
    echo
    cat benches/measured.md
} >"$new"
cat "$new" >benches/README.md
