#!/bin/bash
# Does the suite notice when one thing is broken? Breaks ten things, one at a time, in a COPY of the tree, builds
# test_core and test_stability (and what else is asked for), and says which of their tests fail. Not part of CI: each
# takes minutes.
#
#   cp -a abut /tmp/mutants && tests/stability/mutations.sh /tmp/mutants [name of a mutation ...]
#
# The copy needs a configured build/release. PROGRAMS adds test programs (default "test_core test_stability"); FILTER is
# the tests' (default: all but the published cases at full size and what takes long).
set -u
tree=$(cd "${1:?a copy of the tree}" && pwd); shift
cd "$tree" || exit 2
programs=${PROGRAMS:-test_core test_stability}
filter=${FILTER:-*-*Full*:LongTimes*:ManyBodies*}
export OMP_WAIT_POLICY=passive OMP_NUM_THREADS=2

# name | file | what is broken (sed)
mutations() {
  cat <<'LIST'
normal-sign|src/contact/normal/regress.h|s/return unit<D>(n);/return -unit<D>(n);/
missing-delta-v|src/step/filter_velocities.cpp|s/if (delta) u -= /if (false) u -= /
wrong-edge-distance|src/contact/separation/particle_edges.h|s/return half_size.cwiseProduct(F.transpose() \* n).norm();/return 0.5 * half_size.cwiseProduct(F.transpose() * n).norm();/
skipped-second-correction|src/step/step.cpp|s/add(effects.contact, "second contact pass"/add(false, "second contact pass"/
wall-impulse-sign|src/boundary/impose.cpp|s/total\[a\] += control.impulse/total[a] -= control.impulse/
missing-J-in-Cauchy|src/results/particle_frame.cpp|s/tau\[c\] \/ J;/tau[c] \/ (1 + 0 * J);/
lumped-for-full-mass|src/step/filter_velocities.cpp|s/order < state.effects.extra_orders; ++order/order < 0; ++order/
friction-without-limit|src/contact/law/friction.h|s/return at_rest \* N;/return 1e30 * N;/
wrong-dF-order|src/step/update_stress.h|s/product<D>(dF, particles.deformation_gradient\[p\])/product<D>(particles.deformation_gradient[p], dF)/
wrong-ledger-work|src/contact/contact_totals.cpp|s/state_.ledger.contact_work += work;/state_.ledger.contact_work -= work;/
LIST
}

wanted=" $* "
while IFS='|' read -r name file change; do
  [[ "$wanted" == "  " || "$wanted" == *" $name "* ]] || continue
  cp -p "$file" /tmp/mutations.original.$$
  sed -i "$change" "$file"
  if cmp -s "$file" /tmp/mutations.original.$$; then
    echo "$name: not applied: $file has changed, see to the sed"
    continue
  fi
  failed=""
  # shellcheck disable=SC2086
  if ! cmake --build build/release --target $programs >/tmp/mutations.build.$$ 2>&1; then
    failed="(does not build)"
  else
    for program in $programs; do
      timeout 400 "build/release/tests/$program" --gtest_filter="$filter" --gtest_brief=1 >/tmp/mutations.run.$$ 2>&1
      failed+=" $program: $(grep -c '^\[  FAILED  \] [A-Za-z]*\.[A-Za-z0-9]* (' /tmp/mutations.run.$$) tests ($(
        grep -o '^\[  FAILED  \] [A-Za-z]*\.[A-Za-z0-9]* (' /tmp/mutations.run.$$ | head -3 | sed 's/.*\] //; s/ ($//' | tr '\n' ' '));"
    done
  fi
  echo "$name: fails in$failed"
  cp -p /tmp/mutations.original.$$ "$file"
  touch "$file"
done < <(mutations)
rm -f /tmp/mutations.*.$$
