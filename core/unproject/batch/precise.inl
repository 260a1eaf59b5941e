// The closed forms with about 30 digits, for rows that must have the digits of a click. Included by
// kernels.inl.

/// A number as high + low, where low may be a few units in the last place of high.
struct TwoPacks {
    Pack high, low;
};

Pack lostBySum(Pack a, Pack b, Pack sum)
{
    const Pack bOfSum = sum - a;
    return (a - (sum - bOfSum)) + (b - bOfSum);
}

TwoPacks difference(Pack a, Pack b)
{
    const Pack high = a - b, minusBOfHigh = high - a;
    return {high, (a - (high - minusBOfHigh)) - (b + minusBOfHigh)};
}

TwoPacks operator+(TwoPacks a, TwoPacks b)
{
    const Pack high = a.high + b.high;
    return {high, lostBySum(a.high, b.high, high) + (a.low + b.low)};
}

/// A factor, split for products (Veltkamp) on processors that do not fuse. Beyond 2^970 it becomes
/// NaN there, and slower code computes the point.
struct Factor {
    TwoPacks number;
    Pack highHalf, lowHalf;

    Factor(TwoPacks a) : number(a)
    {
        const Pack product = Pack(0x1p27 + 1.0) * a.high;
        highHalf = product - (product - a.high);
        lowHalf = a.high - highHalf;
    }
    Factor(const Twofold &a) : number{Pack(a.value), Pack(a.rest)}, highHalf(Pack(a.highHalf)), lowHalf(Pack(a.lowHalf))
    {
    }
};

/// The error of a product in double: what it loses of a b. A fused operation gives it in one step;
/// Dekker's algorithm gives the same number.
template <class OfPack>
OfPack lostByProduct(const Factor &a, const Factor &b, OfPack product)
{
    if constexpr (OfPack::kFuses)
        return OfPack::productMinus(a.number.high, b.number.high, product);
    else
        return a.lowHalf * b.lowHalf
               - (((product - a.highHalf * b.highHalf) - a.lowHalf * b.highHalf) - a.highHalf * b.lowHalf);
}

/// a b + c, rounded once or twice: the difference is far below the digits that are kept.
template <class OfPack>
OfPack productPlus(OfPack a, OfPack b, OfPack c)
{
    if constexpr (OfPack::kFuses)
        return OfPack::productPlus(a, b, c);
    else
        return a * b + c;
}

TwoPacks operator*(const Factor &a, const Factor &b)
{
    const Pack high = a.number.high * b.number.high, lost = lostByProduct(a, b, high);
    return {high, productPlus(a.number.high, b.number.low, productPlus(a.number.low, b.number.high, lost))};
}

TwoPacks quotient(TwoPacks a, TwoPacks b)
{
    const Pack reciprocal = Pack(1.0) / b.high, high = a.high * reciprocal, product = high * b.high;
    const Pack lost = lostByProduct(Factor(TwoPacks{high, Pack(0.0)}), Factor(b), product);
    return {high, (((a.high - product) - lost) + (a.low - high * b.low)) * reciprocal};
}

/// high + low rounded to a double, if all numbers within `error` of it have the same rounding. What
/// the sums with low lose is far below `error`.
/// @return a value above 0, or NaN, if they do not
Pack rounded(TwoPacks number, Pack error, Pack &to)
{
    to = number.high + (number.low + error);
    return to - (number.high + (number.low - error));
}

/// Both closed forms; see PreciseConstants.
template <bool isPerspective>
void unprojectPrecisely(const PreciseConstants &c, Pack px, Pack py, Pack d, Pack (&p)[3], Pack &doubt)
{
    const TwoPacks right = difference(px, Pack(c.axisX.value)), up = difference(Pack(c.axisY.value), py);
    const Factor x(TwoPacks{right.high, right.low - Pack(c.axisX.rest)});
    const Factor y(TwoPacks{up.high, up.low + Pack(c.axisY.rest)});
    const TwoPacks toFar = difference(Pack(c.depthAtFar), d), fromNear = difference(d, Pack(c.depthAtNear));
    const TwoPacks atNear = isPerspective ? toFar : Factor(toFar) * Factor(c.nearTerm);
    const TwoPacks both = atNear + Factor(fromNear) * Factor(c.farTerm);
    const TwoPacks distance =
        isPerspective ? quotient(TwoPacks{Pack(c.nearTerm.value), Pack(c.nearTerm.rest)}, both) : both;
    const Factor z(distance);

    Pack size =
        Pack(c.reach) + (magnitude(x.number.high) * Pack(c.acrossSize) + magnitude(y.number.high) * Pack(c.upSize));
    if (isPerspective)
        size = size * magnitude(distance.high);
    const Pack error = (Pack(c.originSize) + size) * Pack(kPreciseError);

    doubt = Pack(0.0);
    for (int k = 0; k < 3; ++k) {
        const TwoPacks origin{Pack(c.origin[k].value), Pack(c.origin[k].rest)};
        const TwoPacks sideways = Factor(c.across[k]) * x + Factor(c.up[k]) * y;
        const TwoPacks ahead{Pack(c.ahead[k].value), Pack(c.ahead[k].rest)};
        const TwoPacks point =
            isPerspective ? origin + Factor(sideways + ahead) * z : origin + (sideways + Factor(c.ahead[k]) * z);
        doubt = doubt + rounded(point, error, p[k]);
    }
}

template <bool isPerspective>
void unprojectPrecisely(const PreciseConstants &constants, const double *px, const double *py, const double *depth,
                        double *x, double *y, double *z, double *doubt, std::size_t count)
{
    const PreciseConstants c = constants; // no store can change it
    const double *const from[3] = {px, py, depth};
    double *const to[4] = {x, y, z, doubt};
    inPacks(from, to, 0, count, [&c](const double *const(&in)[3], double *const(&out)[4], std::size_t i) {
        Pack p[3], uncertain;
        unprojectPrecisely<isPerspective>(c, Pack::loaded(in[0] + i), Pack::loaded(in[1] + i), Pack::loaded(in[2] + i),
                                          p, uncertain);
        for (int k = 0; k < 3; ++k)
            p[k].store(out[k] + i);
        uncertain.store(out[3] + i);
    });
}

/// The method of gluUnProject, each step rounded as in MatrixInverse.
class ClickMatrix {
public:
    using Constants = ClickMatrixConstants;

    ClickMatrix(const Constants &c, Pack py)
        : m_y(Pack(2.0) * ((Pack(c.surfaceHeight) - py) - Pack(c.y)) / Pack(c.height) - Pack(1.0))
    {
    }
    void unproject(const Constants &c, Pack px, Pack d, Pack (&p)[3]) const
    {
        const Pack x = Pack(2.0) * (px - Pack(c.x)) / Pack(c.width) - Pack(1.0);
        const Pack z = Pack(c.depthScale) * (d - Pack(c.depthAtNear)) / Pack(c.depthSize) - Pack(c.depthOffset);
        const auto product = [&](int row) { // in GLM's order
            return (Pack(c.rows[row][0]) * x + Pack(c.rows[row][1]) * m_y)
                   + (Pack(c.rows[row][2]) * z + Pack(c.rows[row][3]));
        };
        const Pack w = product(3);
        for (int k = 0; k < 3; ++k)
            p[k] = product(k) / w;
    }

private:
    Pack m_y;
};
