#!/bin/bash
# A function that is compiled for AVX2 or AVX-512 has no twin in any other object: the linker keeps one of two, and the
# rest of the program would be led to instructions that its processor may not have.
#   tests/build/kernels.sh OBJECT…     all objects of the library
set -euo pipefail

defined_in() { nm -C --defined-only "$@" 2>/dev/null | sed -nE 's/^[0-9a-f]+ [TW] //p' | sort -u; }

failed=0 kernels=0
for kernel in "$@"; do
  case $kernel in *_avx2.cpp.o | *_avx512.cpp.o) ;; *) continue ;; esac
  kernels=$((kernels + 1))
  others=()
  for object in "$@"; do [[ $object == "$kernel" ]] || others+=("$object"); done
  twins=$(comm -12 <(defined_in "$kernel") <(defined_in "${others[@]}"))
  if [[ -n $twins ]]; then
    echo "kernels: ${kernel##*/} shares with other objects:"$'\n'"$twins" >&2
    failed=1
  fi
done
echo "kernels: $kernels units looked at"
exit $failed
