#!/bin/bash
# Boots a Debian 12 with systemd in a container without network and tries the package fovea-server
# there: its unit with certificates and tokens that only root may read, system calls (one that the
# unit does not allow ends the server), reload, watchdog, upgrade, what was disabled, purge.
# Needs root and the packages podman, runc, mmdebstrap and openssl.
# usage: deploy/try_service.sh BUILD_FOLDER   (after make package)
set -euo pipefail
build=$1

for tool in podman runc mmdebstrap openssl; do
  command -v "$tool" >/dev/null || { echo "try_service: $tool is missing: apt-get install $tool" >&2; exit 1; }
done
work=$(mktemp -d)
root=$work/root
podman=(podman --storage-driver vfs --root "$work/store" --runroot "$work/run" --runtime runc
  --cgroup-manager cgroupfs --events-backend none)
trap '"${podman[@]}" rm --force --ignore --time 0 system >/dev/null 2>&1 || true; rm -rf "$work"' EXIT

inside() { "${podman[@]}" exec system "$@"; }
fail() {
  echo "try_service: $*" >&2
  inside journalctl --unit fovea-server --no-pager --lines 20 >&2 || true
  exit 1
}
main_pid() { inside systemctl show --property MainPID --value fovea-server; }
expect() { # what, command that prints it...
  local what=$1 said
  shift
  said=$(inside "$@" || true)
  [ "$said" = "$what" ] || fail "$*: $said, not $what"
}
install_package() { inside sh -c 'dpkg --install /packages/fovea-server_*.deb' >/dev/null; }
configure_unit() { # lines of [Service]
  inside mkdir -p /etc/systemd/system/fovea-server.service.d
  printf '[Service]\n%s\n' "$1" | "${podman[@]}" exec -i system sh -c \
    'cat >/etc/systemd/system/fovea-server.service.d/try.conf; systemctl daemon-reload'
}

# What the packages depend on is installed before, the server's own package is tried afterwards.
make_root() {
  mmdebstrap --quiet --variant=minbase --include=systemd,systemd-sysv,dbus bookworm "$root"
  cp /etc/resolv.conf "$root/etc/"
  mkdir "$root/packages"
  cp "$build"/fovea-server_*.deb "$build"/fovea-client_*.deb "$root/packages/"
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive sh -c \
    'apt-get update -q && apt-get install -y -q --no-install-recommends /packages/*.deb &&
     dpkg --purge fovea-server' >"$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; exit 1; }
  "$build/tests/support/fovea-scenes" --output "$root/frames" --kind tabletop --count 1 --seed 7 >/dev/null
}

boot() {
  "${podman[@]}" run --detach --name system --systemd always --privileged --network none \
    --ulimit nofile=4096:4096 --ulimit nproc=4096:4096 --rootfs "$root" /lib/systemd/systemd >/dev/null
  until inside systemctl is-system-running 2>/dev/null | grep -qE 'running|degraded'; do sleep 0.1; done
  # As on a machine; systemd 252 leaves that to whoever makes the container.
  inside sh -c 'mount --make-rshared / && mount --make-rshared /run'
}

# As docs/operations.md has it.
protect() {
  local keys=$root/etc/fovea credentials=/run/credentials/fovea-server.service
  openssl req -x509 -newkey rsa:2048 -nodes -days 1 -subj /CN=fovea -addext subjectAltName=IP:127.0.0.1,DNS:localhost \
    -keyout "$keys/server.key" -out "$keys/server.pem" 2>/dev/null
  printf secret >"$keys/token"
  echo "robot $(sha256sum <"$keys/token" | cut -d' ' -f1)" >"$keys/tokens"
  chmod 0600 "$keys"/server.* "$keys"/token*
  cat >"$keys/fovea-server.toml" <<END
listen = ["127.0.0.1:50051", "unix:/run/fovea/fovea.sock"]
metrics-listen = "127.0.0.1:9464"
tls-cert = "$credentials/server.pem"
tls-key = "$credentials/server.key"
tokens = "$credentials/tokens"
hold-s = 1
END
}

check_unit() {
  protect
  configure_unit "SystemCallErrorNumber=
LoadCredential=server.pem:/etc/fovea/server.pem
LoadCredential=server.key:/etc/fovea/server.key
LoadCredential=tokens:/etc/fovea/tokens
Group=fovea-clients
WatchdogSec=3"
  inside groupadd --system fovea-clients
  inside systemctl restart fovea-server || fail "it does not start"
  local pid
  pid=$(main_pid)
  local ask=(--server 127.0.0.1:50051 --tls-ca /etc/fovea/server.pem --token-file /etc/fovea/token)
  inside fovea health "${ask[@]}" || fail "it does not serve"
  inside sh -c 'mkdir /results; fovea detect "$@" --intrinsics 525,525,319.5,239.5 --input /frames --output /results' \
    - "${ask[@]}" || fail "it does not detect"
  # A user who is no root, in the group that may connect and in none.
  inside sh -c 'cp /etc/fovea/server.pem /etc/fovea/token /tmp; chmod 0444 /tmp/server.pem /tmp/token'
  ask_socket() { # group
    inside setpriv --reuid nobody --regid "$1" --clear-groups fovea health \
      --server unix:/run/fovea/fovea.sock --tls-ca /tmp/server.pem --token-file /tmp/token
  }
  ask_socket fovea-clients || fail "its group may not connect to the UNIX socket"
  ! ask_socket nogroup 2>/dev/null || fail "anybody may connect to the UNIX socket"
  inside systemctl reload fovea-server || fail "it does not reload"
  expect active systemctl is-active fovea-server
  inside bash -c 'exec 3<>/dev/tcp/127.0.0.1/9464; printf "GET /metrics HTTP/1.0\r\n\r\n" >&3; grep fovea_build_info{ <&3'
  [ "$(main_pid)" = "$pid" ] || fail "it was restarted"
  inside grep -qx 'Seccomp:.2' "/proc/$pid/status" || fail "system calls are not filtered"
  echo "keys by LoadCredential, UNIX socket, system calls, reload: as it should be"

  inside sh -c "kill -STOP $pid"
  # For WatchdogSec, then for TimeoutStopSec, since what is stopped does not end by itself.
  while [ "$(main_pid)" = "$pid" ] || ! inside systemctl --quiet is-active fovea-server; do sleep 0.2; done
  inside fovea health "${ask[@]}" || fail "the watchdog does not bring it back"
  inside journalctl --unit fovea-server --no-pager --grep 'Watchdog timeout' --output cat
}

check_package() {
  local pid
  pid=$(main_pid)
  install_package
  [ "$(main_pid)" != "$pid" ] || fail "an upgrade does not restart it"
  expect active systemctl is-active fovea-server
  inside systemctl disable --quiet --now fovea-server
  install_package
  expect disabled systemctl is-enabled fovea-server
  expect inactive systemctl is-active fovea-server
  inside systemctl enable --quiet --now fovea-server
  inside sh -c 'rm -r /etc/systemd/system/fovea-server.service.d; dpkg --purge fovea-server' >/dev/null 2>&1
  expect inactive systemctl is-active fovea-server
  expect "" sh -c 'find /etc /lib/systemd /usr/bin -name "fovea-server*"'
  echo "upgrade restarts, disabled stays disabled, purge stops and removes"
}

make_root
boot
install_package
expect active systemctl is-active fovea-server
expect enabled systemctl is-enabled fovea-server
inside fovea health
check_unit
check_package
