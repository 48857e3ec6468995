# The cost of each query of the example `measure`, of what the plugin cycles.c saw of its calls:
# `awk -F, -v header=… -v columns=… -f .ci/calls.awk <calls> <table>`. With `clock` the first column
# is held against what the board's own clock counted.
#
# Of each group of queries, which the example measures in turns: for each batch of 32 pairs and
# each query a call that asks, one that asks nothing, one that asks nothing for the stack, and one that
# asks again for the stack. A board knows the third after the first batch; a host asks it each time.
# Meshes, which come last, are asked otherwise, and are left out.
function batches_of(queries) { return clock ? (many[group] / queries - 1) / 3 : many[group] / queries / 4 }
# A host asks all 256 pairs; a board stops where it has enough.
function is_whole(queries) { return clock ? batches_of(queries) % 1 == 0 : batches_of(queries) == 8 }
BEGIN { batch = 32; group = groups = calls = 0 }
FNR == NR && /^log/ { if (calls) groups++; calls = 0; next }
FNR == NR { split($0, count, " "); for (k in count) sum[groups + 0, calls, k] = count[k]
    calls++; many[groups + 0] = calls; next }
FNR == 1 { print header; next }
/,mesh\// { next }
{ line[++lines] = $2 "," $3 "," $4 "," $5; kind[lines] = $3 "," $5; told[lines] = $6 }
END {
    for (first = 1; first <= lines; first = last + 1) {
        for (last = first; last < lines && kind[last + 1] == kind[first]; last++) {}
        # Groups of the same kind may follow each other.
        for (queries = last - first + 1; queries > 1 && !is_whole(queries); queries--) {}
        last = first + queries - 1
        batches = batches_of(queries)
        if (!is_whole(queries)) { print "calls and lines do not fit" > "/dev/stderr"; exit 1 }
        for (q = 0; q < queries; q++) {
            row = line[first + q]
            pairs = batches * batch
            for (k = 1; k <= columns; k++) {
                total = 0
                for (b = 0; b < batches; b++) {
                    at = !clock || b == 0 ? 4 * (b * queries + q) : queries + 3 * (b * queries + q)
                    total += sum[group, at, k] - sum[group, at + 1, k]
                }
                # It is right to a thousandth, if all batches are full. One ends at a pair that is refused.
                by_clock = told[first + q]
                if (clock && k == 1 && (total / pairs - by_clock) ^ 2 > (2 + by_clock / 500) ^ 2) {
                    pairs = int(total / by_clock + 0.5)
                    if (pairs > batches * batch || pairs < batches) {
                        print row ": " total " instructions, and by the clock each " by_clock > "/dev/stderr"
                        exit 1
                    }
                }
                cost = int(total / pairs + 0.5)
                row = row "," cost
            }
            print row
        }
        group++
    }
}
