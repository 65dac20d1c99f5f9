#!/usr/bin/env bash
# ledger_coverage.sh LEDGER REPORT: every owed statement has its record and its control, at every precision
# that applies.
set -euo pipefail
"$1" merge "$2"
"$1" verify "$2"
