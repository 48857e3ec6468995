# The cost of each query of the example `measure`, of what the plugin cycles.c saw of its calls:
# `awk -F, -v header=… -v columns=… -f .ci/calls.awk <calls> <table>`. With `clock` the first column
# is held against what the board's own clock counted.
#
# Of each group of queries, which the example measures in turns: for each batch of 32 pairs and
# each query a call that asks, two that ask nothing, and one that asks again, for the stack. Meshes,
# which come last, are asked otherwise, and are left out.
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
        queries = last - first + 1
        batches = many[group] / (4 * queries)
        if (batches != int(batches) || batches < 1) { print "calls and lines do not fit" > "/dev/stderr"; exit 1 }
        for (q = 0; q < queries; q++) {
            row = line[first + q]
            for (k = 1; k <= columns; k++) {
                total = 0
                for (b = 0; b < batches; b++) {
                    at = 4 * (b * queries + q)
                    total += sum[group, at, k] - sum[group, at + 1, k]
                }
                cost = int(total / batches / batch + 0.5)
                # It is right to a thousandth.
                if (clock && k == 1 && (cost - told[first + q]) ^ 2 > (2 + told[first + q] / 500) ^ 2) {
                    print row ": " cost " instructions, and by the clock " told[first + q] > "/dev/stderr"
                    exit 1
                }
                row = row "," cost
            }
            print row
        }
        group++
    }
}
