//! Whether zero is a convex combination of some points: linear programming in integers.

use dashu_int::IBig;

/// Whether there are weights, not negative and with a sum of one, for which the points sum to zero.
///
/// The first phase of the simplex method, with integer pivots (J. Edmonds, J.-F. Maurras, "Note sur
/// les Q-matrices d'Edmonds", *RAIRO* 31, 1997). Entering and leaving variables follow the rule of
/// R. G. Bland ("New Finite Pivoting Rules for the Simplex Method", *Mathematics of Operations
/// Research* 2, 1977), so that it terminates.
pub fn holds_zero(points: &[[IBig; 3]]) -> bool {
    let n = points.len();
    // Three sums of coordinates are zero, and the sum of the weights is one. The last row is the
    // infeasibility, to be brought to zero; the last column holds the right-hand sides.
    let mut rows: Vec<Vec<IBig>> = (0..3)
        .map(|i| points.iter().map(|p| p[i].clone()).chain([IBig::ZERO]).collect())
        .chain([vec![IBig::ONE; n + 1]])
        .collect();
    let missing = (0..=n).map(|j| rows.iter().map(|row| &row[j]).sum()).collect();
    rows.push(missing);
    let mut basis: [usize; 4] = [n, n + 1, n + 2, n + 3];
    let mut divisor = IBig::ONE;
    loop {
        let Some(enters) = (0..n).find(|&j| !basis.contains(&j) && rows[4][j] > IBig::ZERO) else {
            return rows[4][n] == IBig::ZERO;
        };
        let candidates = (0..4).filter(|&r| rows[r][enters] > IBig::ZERO);
        let leaves = candidates.min_by(|&r, &s| {
            let (a, b) = (&rows[r][n] * &rows[s][enters], &rows[s][n] * &rows[r][enters]);
            a.cmp(&b).then(basis[r].cmp(&basis[s]))
        });
        // A positive sum has a positive summand; artificial weights only leave.
        let Some(leaves) = leaves else { return false };
        let by = rows[leaves].clone();
        for (r, row) in rows.iter_mut().enumerate().filter(|(r, _)| *r != leaves) {
            let factor = row[enters].clone();
            if r == 4 || factor != IBig::ZERO || divisor != by[enters] {
                for j in 0..=n {
                    row[j] = (&row[j] * &by[enters] - &by[j] * &factor) / &divisor;
                }
            }
        }
        divisor = by[enters].clone();
        basis[leaves] = enters;
    }
}

#[cfg(test)]
mod tests {
    use super::holds_zero;
    use dashu_int::IBig;

    #[test]
    fn tells_inside_from_outside() {
        let points = |list: &[[i32; 3]]| -> Vec<[IBig; 3]> {
            list.iter().map(|p| p.map(IBig::from)).collect()
        };
        let simplex = [[3, -1, -1], [-1, 3, -1], [-1, -1, 3], [-1, -1, -1]];
        assert!(holds_zero(&points(&simplex)));
        assert!(!holds_zero(&points(&simplex.map(|p| [p[0] + 2, p[1], p[2]]))));
        // On a face, on an edge, at a vertex, and beside them.
        assert!(holds_zero(&points(&simplex.map(|p| [p[0] + 1, p[1], p[2]]))));
        assert!(holds_zero(&points(&simplex.map(|p| [p[0] + 1, p[1] + 1, p[2]]))));
        assert!(holds_zero(&points(&simplex.map(|p| [p[0] + 1, p[1] + 1, p[2] + 1]))));
        assert!(!holds_zero(&points(&[[1, 0, 0], [2, 0, 0]])));
        assert!(holds_zero(&points(&[[-1, 0, 0], [2, 0, 0]])));
        assert!(!holds_zero(&[]));
    }
}
