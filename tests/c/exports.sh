#!/bin/bash
# The library shows the functions of its header and nothing else.   exports.sh LIBRARY HEADER
set -euo pipefail
shown=$(nm -D --defined-only --format=posix "$1" | cut -d' ' -f1 | sort)
declared=$(grep -o '\bswayaw_[a-z_]*(' "$2" | tr -d '(' | sort -u)
diff <(echo "$declared") <(echo "$shown") || { echo "exports: < declared, > shown" >&2; exit 1; }
