# The square root of a float, from the root of an integer.
# constant: ROOT_ROUNDOFFS
# only: f64
#
# The true root is one, and the first root is below it by less than 2^-31 of it.
# Its quotient is exact in 1 + e + e²/(1 - e), where e is what the first lacks, and the last of these is the rest.

# The first root, 1 - e, and the quotient, (1 + e + rest)·(1 + d1), in one sum.
sum = 2 + rest + (1 + e + rest)*d1;
root = 0.5*sum*(1 + d2);

{ e in [0,1b-31] /\ rest in [0,2.2e-19] /\ |d1| <= 1b-53 /\ |d2| <= 1b-53
-> |root - 1| - ROOT_ROUNDOFFS*U <= 0 }
