#!/usr/bin/env bash
# bare_system.sh SYSTEM PACKAGE.deb: installs the Debian package in a copy of a bare Debian 12, works with it as an
# ordinary user without sources, and removes it. Needs root and the network; no part of `./moat test`. The bare system:
#   debootstrap --variant=minbase bookworm SYSTEM
set -euo pipefail

system=$(realpath -- "$1")
package=$(realpath -- "$2")
if [[ -z ${BARE_SYSTEM_OF_ITS_OWN-} ]]; then # mounts below must not reach the machine
  BARE_SYSTEM_OF_ITS_OWN=yes exec unshare --mount --propagation private bash "$0" "$system" "$package"
fi
copy=$(mktemp -d)
trap 'umount --lazy "$copy/proc" "$copy/dev" && rm -r --one-file-system "$copy"' EXIT
cp -a "$system/." "$copy"
cp /etc/resolv.conf /etc/hosts "$copy/etc"
cp "$package" "$copy/root/moat.deb"
mount -t proc proc "$copy/proc"
mount --rbind /dev "$copy/dev"

inside() {
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} chroot "$copy" "$@"
}
inside apt-get update -qq
inside apt-get install -y -qq --no-install-recommends /root/moat.deb >"$copy/install.log" 2>&1 ||
  { tail "$copy/install.log" && exit 1; }
inside useradd --create-home --shell /bin/bash user

cat >"$copy/home/user/work.sh" <<'END'
set -euxo pipefail
moat --help | grep "moat run /usr/share/moat/examples/01_moat_wall.cpp"
moat doctor
moat new tower
moat run tower.cpp --out tower
grep -q "<svg" tower/report.html
grep -qi "dygraph" tower/report.html
moat report tower
moat run tower.cpp --json | grep -q '"impacts"'
moat run /usr/share/moat/examples/05_plan.cpp --end "1 s" --quiet
moat run /usr/share/moat/examples/10_gap_study.cpp --out study
moat study show study
moat run --ranks 2 /usr/share/moat/examples/12_fragility.cpp
printf '%s\n' SYNTHETIC Test "ACCELERATION TIME SERIES IN UNITS OF G" "NPTS= 3, DT= .01 SEC" "0. .1 0." >a.AT2
moat motion a.AT2
source <(moat completion bash)
complete -p moat
END
inside su - user -c 'bash work.sh'
inside apt-get remove -y -qq moat >/dev/null
left=$(inside find /usr /etc /var/lib -path /var/lib/dpkg -prune -o -name '*moat*' -print)
[[ -z $left ]] || { echo "FAILED: apt-get remove left $left" && exit 1; }
echo "The package was installed, used and removed."
