# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What ./run and ./check have in common; sourced by both, from the project's root.

kLogs=build/log
kRunPackages=(
  build-essential cmake ninja-build pkg-config
  libassimp-dev libbox2d-dev libeigen3-dev libfmt-dev libode-dev libpng-dev librandom123-dev libtinyxml2-dev
  libyaml-cpp-dev                                               # the library
  libboost-math-dev libcli11-dev nlohmann-json3-dev gnuplot-nox  # the hexagait command
)
# hexagait steer: its server, and replays; and for its page Node.js with npm, where there is none of another source.
# Without the page all else is built and tested: Debian's npm brings some hundred packages.
kSteerPackages=(libwebsockets-dev zlib1g-dev)
kPagePackages=()
command -v node >/dev/null || kPagePackages+=(nodejs)
command -v npm >/dev/null || kPagePackages+=(npm)
kBuildPackages=(
  "${kRunPackages[@]}" ccache
  libbenchmark-dev libgmock-dev libgtest-dev libnlopt-dev liborocos-kdl-dev
  librapidcheck-dev                                             # benchmarks and tests
  "${kSteerPackages[@]}"
)
kCheckPackages=(clang clang-format clang-tidy libclang-rt-14-dev universal-ctags chromium "${kPagePackages[@]}")

export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1  # one clone finds what another has compiled
export CCACHE_SLOPPINESS=pch_defines,time_macros  # or it keeps nothing that has precompiled headers
# The user preset takes ccache where it is; the others ask for it.
! command -v ccache >/dev/null || export CMAKE_CXX_COMPILER_LAUNCHER=ccache

exec 3>&1  # for progress, from inside a step

say() { printf '%s\n' "$*" >&3; }

# step TITLE COMMAND…: runs it with its output in build/log and says how long it took. A command may
# leave one line to be shown in $note. If it fails, so does the script, with the end of the output.
step() {
  local title=$1 log=$kLogs/${1// /-}.log begin=$SECONDS status
  shift
  mkdir -p "$kLogs"
  note=$(mktemp)
  printf '%-20s' "$title" >&3
  set +e
  (set -e; "$@") >"$log" 2>&1 </dev/null
  status=$?
  set -e
  if ((status == 0)); then
    [[ -t 3 ]] && printf '\r%-20s' "$title" >&3
    printf '%6d s   %s\n' $((SECONDS - begin)) "$(cat "$note")" >&3
    rm -f "$note"
    return
  fi
  rm -f "$note"
  printf '  FAILED\n' >&3
  tail -n 60 "$log" >&2
  printf '\nFailed: %s, after %d s. All of its output: %s\n' "$title" $((SECONDS - begin)) "$log" >&2
  exit 1
}

# Copies what ninja or ctest prints, and shows how far it is: at every per cent on a terminal, else
# at every 20.
progress() {
  local line percent shown=0
  while IFS= read -r line; do
    printf '%s\n' "$line"
    [[ $line =~ ^[\[\ ]*([0-9]+)/([0-9]+)[\]\ ] ]] || continue
    percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2]))
    if [[ -t 3 ]]; then
      printf '\b\b\b\b\b%3d %%' "$percent" >&3
    elif ((percent >= shown + 20)); then
      shown=$((percent / 20 * 20))
      printf ' %d%%' "$shown" >&3
    fi
  done
}

# Installs what is missing of the given Debian packages.
install_packages() {
  command -v dpkg-query >/dev/null || {
    say "Not a Debian: taking it that these are installed: $*"
    return 0
  }
  local package missing=() installed
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null || true)
  for package in "$@"; do
    grep -qx "$package installed" <<<"$installed" || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  local root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || {
      say "Missing, and neither root nor sudo to install it. As root: apt-get install ${missing[*]}"
      exit 1
    }
    root=(sudo)
    sudo -v  # asks for a password here, where one can be typed
  fi
  say "Installing from Debian: ${missing[*]}"
  step "packages" apt_get_install "${missing[@]}"
}

apt_get_install() {
  local apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o Acquire::Retries=3)
  "${apt[@]}" update
  "${apt[@]}" install -y --no-install-recommends "$@"
}

# build PRESET [OPTION…]: configures it and builds, all or what the options say.
build() {
  local preset=$1
  shift
  cmake --preset "$preset"
  cmake --build --preset "$preset" --parallel "$(nproc)" "$@" | progress
}
