#!/bin/sh
# run_pytest.sh PYTHON FILE: exit status 77, skipped, where NumPy or pytest are absent.
"$1" -c 'import numpy, pytest' 2>/dev/null || {
  echo "skipped: NumPy or pytest is not installed (Debian 12: apt-get install python3-numpy python3-pytest)"
  exit 77
}
exec "$1" -m pytest -q -p no:cacheprovider "$2"
