#!/bin/bash
# Exported kinematics in LinuxCNC itself, headless and as an ordinary user: homed, moved to ten poses a robot, joint positions compared.
# Installs Debian's linuxcnc-uspace where root and apt-get are there; skipped, saying so, where it cannot.
# usage: linuxcnc.sh ETALON
set -euo pipefail
etalon=$(realpath "$1") here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $1"; exit 0; }
[ "$(id -u)" = 0 ] || skip "halcompile installs components as root"
# LinuxCNC's programs are for Debian's own Python
if ! { command -v linuxcnc && command -v halcompile; } >/dev/null; then
    command -v apt-get >/dev/null || skip "there is no linuxcnc, and no apt-get"
    { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends linuxcnc-uspace linuxcnc-uspace-dev >/dev/null; } \
        || skip "linuxcnc-uspace could not be installed"
fi
/usr/bin/python3 -c 'import linuxcnc' || skip "there is no Python module linuxcnc"

D=$(mktemp -d)
module=/usr/lib/linuxcnc/modules/etalonkins.so
[ ! -e "$module" ] || skip "$module is there already"
# LinuxCNC does not run as root, and asks the system for its user's home
user=etalon-linuxcnc
end() {
    rm -f "$module"
    userdel "$user"
    [ "${KEEP:-}" ] || rm -rf "$D"
}
useradd --system --home-dir "$D/home" "$user"
install -d -o "$user" "$D/home"
trap end EXIT
chmod 755 "$D"
for sample in hexapod contacts dextar prexyt-cmm; do
    cp -r "$here/../../samples/$sample" "$D/$sample"
    # genserkins holds less than was identified: the run says which values it holds, and the sample's limit is for all of them
    [ "$sample" != contacts ] || sed -i -e '1i controllers = ["linuxcnc"]' -e '/^\[limits\]/,$d' "$D/$sample/campaign.toml"
    "$etalon" run "$D/$sample" >"$D/$sample.log" 2>&1 || { cat "$D/$sample.log"; exit 1; }
done
/usr/bin/python3 "$here/cases.py" "$etalon" "$D" "$here/drive.py" "$user"
