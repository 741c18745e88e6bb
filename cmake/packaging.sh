# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What `./check --all` does about switches, installed headers and packages; sourced by it.
# shellcheck shell=bash disable=SC2154  # $note is set by step, in setup.sh

kPrefix=build/installed
kUnity=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=64)  # as build/release, or ccache finds nothing
kComponents=(controller urdf actions verify sim sim2d sim3d walk statistics figures recording viewer
             sweeps)

# The foreign libraries that a component, or a switch, may use; Eigen always.
declare -A kForeign=(
  [urdf]='tinyxml2 assimp' [actions]='fmt yaml-cpp' [verify]=fmt [sim2d]=box2d [sim3d]='ode libpng zlib'
  [walk]='fmt yaml-cpp' [figures]=fmt [recording]='fmt yaml-cpp box2d ode libpng zlib tinyxml2 assimp'
  [viewer]='fmt yaml-cpp box2d ode libpng zlib tinyxml2 assimp libwebsockets libcap'
  [sweeps]='fmt yaml-cpp box2d ode libpng zlib tinyxml2 assimp')

# What pkg-config sees; each of several configurations at a time has its own.
visible=$PWD/build/visible

# in_lanes COMMAND ARGUMENT…: runs the command with each argument, as many at a time as there are
# processors: what configures uses only one. Prints their outputs one after another, and those that
# failed once more at the end.
in_lanes() {
  local command=$1 argument logs=$PWD/build/lanes k running=() failed=()
  shift
  rm -rf "$logs"
  mkdir -p "$logs"
  for argument; do
    while (($(jobs -rp | wc -l) >= $(nproc))); do sleep 0.05; done
    "$command" "$argument" >"$logs/${#running[@]}" 2>&1 &
    running+=($!)
  done
  for k in "${!running[@]}"; do
    wait "${running[k]}" || failed+=("$logs/$k")
    cat "$logs/$k"
  done
  ((${#failed[@]} == 0)) || { tail -n 40 "${failed[@]}"; return 1; }
}

# hide_but LIBRARY…: prints options that hide all foreign libraries but these from find_package, and
# leaves of pkg-config's files in $visible those of these.
hide_but() {
  local library file
  for library in fmt yaml-cpp box2d Boost nlohmann_json CLI11 GTest rapidcheck benchmark; do
    [[ " $* " == *" $library "* ]] || printf -- '-DCMAKE_DISABLE_FIND_PACKAGE_%s=ON\n' "$library"
  done
  rm -rf "$visible"
  mkdir -p "$visible"
  for library in eigen3 "$@"; do
    for file in /usr/{lib,lib/*,share}/pkgconfig/"$library"*.pc; do
      [[ ! -f $file ]] || sed "s|\${pcfiledir}|${file%/*}|" "$file" >"$visible/${file##*/}"
    done
  done
}

# none COMMAND…: fails if the command finds something.
none() { ! "$@"; }

# configure DIR OPTION…: only what is in $visible is there for pkg-config.
configure() {
  PKG_CONFIG_LIBDIR=$visible cmake -S . -B "$1" -G Ninja -DCMAKE_CXX_COMPILER=g++ \
    "${kUnity[@]}" -DHEXAGAIT_WERROR=ON -DHEXAGAIT_TOOLS=OFF -DHEXAGAIT_TESTS=OFF "${@:2}"
}

# combination "URDF ACTIONS SIM2D SIM3D FIGURES VIEWER SWEEPS", each ON or OFF: what is off is not even
# looked for. As deep as build/release, or ccache finds nothing.
combination() {
  local urdf actions sim2d sim3d figures viewer sweeps meshes=OFF dir=build/combination-${1// /-}
  local visible=$PWD/$dir.visible libraries=() hidden
  read -r urdf actions sim2d sim3d figures viewer sweeps <<<"$1"
  [[ $urdf == OFF ]] || libraries+=(tinyxml2 fmt)  # fmt: verify, below
  [[ $urdf$actions != ONON ]] || { meshes=ON; libraries+=(assimp); }
  [[ $actions == OFF ]] || libraries+=(fmt yaml-cpp)
  [[ $sim2d == OFF ]] || libraries+=(box2d)
  [[ $sim3d == OFF ]] || libraries+=(ode)
  [[ $figures == OFF ]] || libraries+=(Boost nlohmann_json)
  [[ $viewer == OFF ]] || libraries+=(libwebsockets libcap zlib)  # libcap: libwebsockets.pc asks for it
  mapfile -t hidden < <(hide_but "${libraries[@]}")
  configure "$dir" "${hidden[@]}" -DHEXAGAIT_URDF=$urdf -DHEXAGAIT_VERIFY=$urdf -DHEXAGAIT_MESHES=$meshes \
    -DHEXAGAIT_ACTIONS=$actions -DHEXAGAIT_SIM2D=$sim2d -DHEXAGAIT_SIM3D=$sim3d \
    -DHEXAGAIT_FIGURES=$figures -DHEXAGAIT_VIEWER=$viewer -DHEXAGAIT_SWEEPS=$sweeps \
    -DHEXAGAIT_PAGE=OFF
  cmake --build "$dir"
  rm -rf "$dir" "$visible"
}

# Each combination of the switches that makes sense.
check_combinations() {
  local urdf actions sim2d sim3d figures viewer sweeps combinations=()
  rm -rf build/combination-*
  for urdf in ON OFF; do for actions in ON OFF; do for sim2d in ON OFF; do for sim3d in ON OFF; do
    for figures in ON OFF; do for viewer in ON OFF; do for sweeps in ON OFF; do
      [[ $figures == OFF || $actions$sim2d$sim3d == ONONON ]] || continue
      [[ $viewer == OFF || $figures == ON ]] || continue
      [[ $sweeps == OFF || $figures$urdf == ONON ]] || continue
      combinations+=("$urdf $actions $sim2d $sim3d $figures $viewer $sweeps")
    done; done; done
  done; done; done; done
  in_lanes combination "${combinations[@]}"
  check_refusals
  printf '%d combinations, %d refused' "${#combinations[@]}" "${#kRefused[@]}" >"$note"
}

# What makes no sense is refused by one message that names both switches; alone, OFF takes along
# what needs it.
kRefused=(FIGURES:ACTIONS FIGURES:SIM2D FIGURES:SIM3D SWEEPS:FIGURES SWEEPS:URDF MESHES:URDF VIEWER:FIGURES)
refused() {
  local dir=build/combination-$1 said
  if said=$(configure "$dir" "-DHEXAGAIT_${1%:*}=ON" "-DHEXAGAIT_${1#*:}=OFF" 2>&1); then
    printf 'not refused: %s\n' "$1"
    return 1
  fi
  grep -q "HEXAGAIT_${1%:*} is ON, but it needs HEXAGAIT_${1#*:}" <<<"$said" ||
    { printf '%s\n' "$said"; return 1; }
  rm -rf "$dir"
}
check_refusals() {
  local dir=build/combination-off
  hide_but fmt yaml-cpp box2d ode tinyxml2 assimp >/dev/null
  in_lanes refused "${kRefused[@]}"
  configure "$dir" -DHEXAGAIT_SIM3D=OFF
  grep -q '^HEXAGAIT_SWEEPS:BOOL=OFF' "$dir/CMakeCache.txt"
  rm -rf "$dir"
}

install_here() {
  rm -rf "$kPrefix"
  cmake --install build/release --prefix "$kPrefix"
}

# What most files include, the largest first: a file reads precompiled the first of these that it includes anyway,
# itself or by a header of ours. So it sees no name that it would not see without.
kPrecompiled=('"commands/commands.hpp"' '<hexagait/experiments/experiment.hpp>' '<hexagait/recording/simulation.hpp>'
              '<hexagait/footstep_gen/walker.hpp>' '<hexagait/executor/executor.hpp>'
              '<hexagait/sim3d/world.hpp>' '<hexagait/model/kinematics.hpp>' '<hexagait/math/geometry.hpp>'
              '<Eigen/Geometry>' '<fmt/format.h>' '<string>')

# files_with HEADER DIR…: the headers and sources below the folders that include the header, themselves or by a
# header of ours.
files_with() {
  local found more names
  found=$(grep -rlF --include='*.[ch]pp' "#include $1" "${@:2}" | sort)
  while names=$(sed -nE 's#^(.*/)?(hexagait/.*hpp)$#<\2>#p; s#^app/(.*hpp)$#"\1"#p' <<<"$found") && [[ -n $names ]] &&
        more=$({ printf '%s\n' "$found"; grep -rlFf - --include='*.[ch]pp' "${@:2}" <<<"$names"; } | sort -u) &&
        [[ $more != "$found" ]]; do found=$more; done
  printf '%s\n' "$found"
}

# check_alone DIR FOLDER…: reads lines COMMAND -c FILE, and runs each for clang to look at the file only.
# What is precompiled, and for which files below the folders, comes first.
check_alone() {
  local dir=$1 k file command
  local -A precompiled=() commands=()
  for k in "${!kPrecompiled[@]}"; do
    while read -r file; do : "${precompiled[$file]:=$k}"; done < <(files_with "${kPrecompiled[k]}" "${@:2}")
  done
  while read -r command; do
    file=${command##* -c }
    k=${precompiled[${file#"$PWD/"}]:-}
    command="${command% -c *} -fPIC"
    [[ -z $k ]] || commands[$k]=$command
    printf '%s -fsyntax-only %s %s\n' "$command" "${k:+-include-pch $dir/$k.pch}" "$file"
  done >"$dir/commands"
  for k in "${!commands[@]}"; do
    printf '#include %s\n' "${kPrecompiled[k]}" >"$dir/$k.hpp"
    printf '%s -fpch-instantiate-templates -x c++-header -o %s.pch %s.hpp\n' "${commands[$k]}" "$dir/$k" "$dir/$k"
  done | xargs -d '\n' -P "$(nproc)" -I{} sh -c {}
  xargs -d '\n' -P "$(nproc)" -I{} sh -c {} <"$dir/commands"
}

# Each source of the library and the command compiles alone: the unity build would not see that one includes too
# little. What the build generates lies in build/release.
check_sources_alone() {
  local dir=$PWD/build/alone
  rm -rf "$dir"
  cmake --preset release -B "$dir" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_COMPILER_LAUNCHER= \
    -DCMAKE_UNITY_BUILD=OFF -DHEXAGAIT_TESTS=OFF -DHEXAGAIT_BENCH=OFF -DHEXAGAIT_PAGE=OFF
  sed -n 's#/build/alone/#/build/release/#g; s/^ *"command": "\(.*\) -o .* \(-c .*\)",$/\1 \2/p' \
    "$dir/compile_commands.json" | sed 's/\\\(.\)/\1/g' | check_alone "$dir" "${kModules[@]}"
  wc -l <"$dir/commands" | awk '{printf "%d sources", $1}' >"$note"
}

# Every installed header compiles alone, and twice, with nothing to include but what is installed.
check_headers() {
  local dir=$PWD/build/headers header
  local command="clang++ -std=c++20 -Wall -Wextra -Werror -I$PWD/$kPrefix/include -isystem /usr/include/eigen3"
  [[ -d $kPrefix ]] || install_here
  rm -rf "$dir"
  mkdir -p "$dir"
  while read -r header; do
    printf '#include <%s>\n#include <%s>\n' "$header" "$header" >"$dir/${header//\//-}.cpp"
  done < <(cd "$kPrefix/include" && find hexagait -name '*.hpp')
  for header in build/headers/*.cpp; do printf '%s -c %s\n' "$command" "$PWD/$header"; done |
    check_alone "$dir" "$kPrefix/include" build/headers
  wc -l <"$dir/commands" | awk '{printf "%d headers", $1}' >"$note"
}

# consume PREFIX COMPONENT: a project of its own finds the component where it is installed, and of
# what else there is only what the component may use; by find_package, then by pkg-config.
consume() {
  local prefix=$PWD/$1 component=$2 dir=build/consumer/$2 hidden allowed pc
  local visible=$PWD/$dir.visible
  read -ra allowed <<<"${kForeign[$component]:-}"
  mapfile -t hidden < <(hide_but "${allowed[@]}")
  local components=$component
  [[ $component != recording && $component != viewer ]] || components="$component;urdf"
  PKG_CONFIG_LIBDIR=$visible cmake -S examples/consumer -B "$dir" -G Ninja \
    -DCMAKE_PREFIX_PATH="$prefix" -DCOMPONENTS="$components" "${hidden[@]}"
  cmake --build "$dir"
  ctest --test-dir "$dir" --output-on-failure
  for pc in fmt yaml-cpp box2d ode tinyxml2 assimp libwebsockets; do
    [[ " ${allowed[*]} " != *" $pc "* ]] || continue
    none grep -E "LINK_LIBRARIES.*lib$pc" "$dir/build.ninja"
    none grep "lib$pc" <(ldd "$dir/use_$component")
  done

  local flags
  pc=$(dirname "$(find "$prefix" -name "hexagait-$component.pc")")
  # shellcheck disable=SC2086  # words on purpose
  flags=$(PKG_CONFIG_LIBDIR=$pc:$visible \
            pkg-config --cflags --libs hexagait-${components//;/ hexagait-})
  # shellcheck disable=SC2086
  ccache g++ -std=c++20 -c -o "$dir/use.o" "examples/consumer/$component.cpp" $flags
  # shellcheck disable=SC2086
  g++ -o "$dir/by_pkg_config" "$dir/use.o" $flags
  LD_LIBRARY_PATH=$pc/.. "$dir/by_pkg_config" "$prefix"/share/hexagait/{robots,actions}
}

consume_installed() { consume "$kPrefix" "$1"; }

# Nothing that is installed knows where it was made; each component brings what it needs.
check_install() {
  install_here
  none grep -rlF "$PWD" "$kPrefix"
  rm -rf build/consumer
  in_lanes consume_installed "${kComponents[@]}"
  hide_but >/dev/null
  if PKG_CONFIG_LIBDIR=$visible cmake -S examples/consumer -B build/consumer/none -G Ninja \
       -DCMAKE_PREFIX_PATH="$PWD/$kPrefix" -DCOMPONENTS=legs >build/consumer/none.log 2>&1; then
    return 1
  fi
  grep -q "without 'legs'" build/consumer/none.log
  printf '%d components' "${#kComponents[@]}" >"$note"
}

# Shared libraries, each linked to all that it uses; and the command beside them.
check_shared() {
  local prefix=build/shared-installed
  cmake -S . -B build/shared -G Ninja -DCMAKE_CXX_COMPILER=g++ -DBUILD_SHARED_LIBS=ON "${kUnity[@]}" \
    -DHEXAGAIT_TESTS=OFF -DHEXAGAIT_WERROR=ON -DCMAKE_SHARED_LINKER_FLAGS=-Wl,--no-undefined
  cmake --build build/shared
  rm -rf "$prefix" build/consumer
  cmake --install build/shared --prefix "$prefix"
  none grep -rlF "$PWD" "$prefix"
  consume "$prefix" controller
  consume "$prefix" sweeps
  "$prefix/bin/hexagait" walk --seconds 1 | tail -n 1
  printf '%d libraries' "$(find "$prefix" -name 'libhexagait_*.so' | wc -l)" >"$note"
}

# The Debian package says what it needs, and works from where it is unpacked.
check_package() {
  local file root=build/package/root depends package
  rm -rf build/package
  mkdir -p "$root"
  (cd build/release && cpack -G DEB -B ../package)
  file=$(echo build/package/*.deb)
  depends=$(dpkg-deb -f "$file" Depends)
  for package in libbox2d-dev libeigen3-dev libfmt-dev libode-dev libpng-dev libtinyxml2-dev libassimp-dev libyaml-cpp-dev libwebsockets-dev zlib1g-dev libc6; do
    [[ "$depends" == *"$package"* ]] || { printf 'no %s in: %s\n' "$package" "$depends"; return 1; }
  done
  [[ $(dpkg-deb -f "$file" Recommends) == gnuplot-nox ]]
  dpkg-deb -x "$file" "$root"
  rm -rf build/consumer
  consume "$root/usr" controller
  "$root/usr/bin/hexagait" run nod --robot argos | tail -n 1
  du -h "$file" | awk '{printf "%s", $1}' >"$note"
}
