#!/usr/bin/env bash
# Writes an archive of the reference campaigns with programs, licence, citation and checksums; the same input gives the same bytes.
# usage: tests/reference/campaigns/archive.sh FOLDER
set -euo pipefail
cd "$(dirname "$0")/../../.."
name=etalon-reference-1
mkdir -p "$1"; folder=$(realpath "$1"); stage=$folder/$name
rm -rf "$stage" "$folder/$name.tar.gz" "$folder/SHA256SUMS"
mkdir -p "$stage/program"
for campaign in samples/reference/*/; do
    mkdir "$stage/$(basename "$campaign")"
    find "$campaign" -maxdepth 1 -type f -exec cp {} "$stage/$(basename "$campaign")/" \;
done
cp samples/reference/CITATION.cff LICENSE "$stage"
[ ! -d LICENSES ] || cp -r LICENSES "$stage"
# links to the repository's documentation have no target in the archive
sed -e 's/\[\([^]]*\)\](\.\.\/\.\.\/docs\/[^)]*)/\1 (documentation of etalon)/g' -e 's|samples/reference/||g' -e 's|samples/reference$|.|' \
    -e 's|tests/reference/campaigns/|program/|g' samples/reference/README.md >"$stage/README.md"
cp tests/reference/campaigns/*.py "$stage/program"
(cd "$stage" && find . -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort | xargs sha256sum >SHA256SUMS)
chmod -R u=rwX,go=rX "$stage"
tar --sort=name --mtime="@${SOURCE_DATE_EPOCH:-0}" --owner=0 --group=0 --numeric-owner --format=ustar -C "$folder" -cf - "$name" | gzip -9n >"$folder/$name.tar.gz"
rm -rf "$stage"
(cd "$folder" && sha256sum "$name.tar.gz" | tee SHA256SUMS)
