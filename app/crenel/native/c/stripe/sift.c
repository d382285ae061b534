/* Step 10: keeps the fitted peaks that are as wide and high as a stripe. */

/* Widths, in shares of the picture's usual one, beyond which a peak is no stripe, and the least
 * standard deviation in px. */
static const double NARROW = 0.45, WIDE = 2.2, LEAST_SIGMA_PX = 0.5;
/* How much further off a width may be where the line goes on on both sides, and over so many
 * columns: rough surfaces and compression change it for a few. */
static const double BETWEEN = 1.5;
enum { LONGEST_BETWEEN = 48 };
/* The misfit from which on a point is less certain. */
static const float MISFIT = 3;
/* Widths are counted in cells of an eighth of an octave; those of one line lie in so many. */
enum { CELLS_PER_OCTAVE = 8, WIDTH_CELLS = 128, LINE_CELLS = 5 };
static const float NARROWEST_CELL = 0.0625f;
/* A piece of line counts in full if it has this many points, else by the square of its share; of
 * a longer one every fourth point is looked at. */
enum { LONG_PIECE = 40, EVERY = 4 };

/* The cell of a width: the leading bits of a float count its eighths of an octave, nearly. */
static int width_cell(float sigma)
{
    const float positive = max_f32(sigma, NARROWEST_CELL);
    uint32_t bits, lowest;
    memcpy(&bits, &positive, sizeof bits);
    memcpy(&lowest, &NARROWEST_CELL, sizeof lowest);
    const uint32_t cell = (bits - lowest) >> 20;
    return cell < WIDTH_CELLS ? (int)cell : WIDTH_CELLS - 1;
}

/* Adds the light of the n fits from `begin` on, which are one piece, to the cells of their
 * widths; widths weighted by it alike. */
static void add_piece(const Workspace *work, int64_t begin, int64_t n, float saturated,
                      double *light, double *moment)
{
    const float *sigma = work->fits + SIGMA * work->padded;
    const float *height = work->fits + AMPLITUDE * work->padded;
    const float share = min_f32((float)n / LONG_PIECE, 1);
    const int every = n < LONG_PIECE ? 1 : EVERY;
    const float weights = share * share * (float)every;
    for (int64_t i = begin; i < begin + n; i += every) {
        const double weight = weights * min_f32(height[i], saturated);
        const int cell = width_cell(sigma[i]);
        light[cell] += weight;
        moment[cell] += weight * sigma[i];
    }
}

/* Whether fit i continues the piece that an earlier fit belongs to. */
static bool follows(const Workspace *work, int64_t before, int64_t i)
{
    const float *centre = work->fits + CENTRE * work->padded;
    const int32_t gap = work->columns[i] - work->columns[before];
    const double rise = work->rows[i] - work->rows[before] + (double)centre[i] - centre[before];
    return run_goes_on(gap, rise, work->climb);
}

/* The usual width of n fitted peaks: that of the brightest and longest pieces of line; 0 where
 * there is none. Clutter has many widths, a line has one. */
static double usual_sigma(const Workspace *work, int64_t n, float saturated)
{
    const float *became = work->fits + BECAME * work->padded;
    double light[WIDTH_CELLS] = {0}, moment[WIDTH_CELLS] = {0};
    for (int64_t i = 0, begin = 0; i < n; i++) {
        if (became[i] != PEAK) {
            begin = i + 1;
        } else if (i + 1 == n || became[i + 1] != PEAK || !follows(work, i, i + 1)) {
            add_piece(work, begin, i + 1 - begin, saturated, light, moment);
            begin = i + 1;
        }
    }
    double most = 0, usual = 0;
    for (int cell = 0; cell + LINE_CELLS <= WIDTH_CELLS; cell++) {
        double lit = 0, weighted = 0;
        for (int k = cell; k < cell + LINE_CELLS; k++) {
            lit += light[k];
            weighted += moment[k];
        }
        if (lit > most) {
            most = lit;
            usual = weighted / lit;
        }
    }
    return usual;
}

/* What a peak of a stripe has: widths between these, as standard deviations, and a height. */
typedef struct {
    double narrowest, widest, least_height;
} Limits;

/* The limits by the usual width, or as set; `slack`: how much further off widths may be. */
static Limits limits_of(const Workspace *work, double usual, double threshold, double slack)
{
    Limits limits = {work->narrowest_px, work->widest_px, threshold};
    if (isnan(limits.narrowest))
        limits.narrowest = max_f64(NARROW * usual / slack, LEAST_SIGMA_PX);
    if (isnan(limits.widest))
        limits.widest = max_f64(WIDE * usual * slack, limits.narrowest);
    return limits;
}

/* Whether fit i is within limits. */
static bool fits_limits(const Workspace *work, const Limits *limits, int64_t i)
{
    const double sigma = work->fits[SIGMA * work->padded + i];
    return work->fits[BECAME * work->padded + i] == PEAK &&
           work->fits[AMPLITUDE * work->padded + i] >= limits->least_height &&
           sigma > limits->narrowest && sigma < limits->widest;
}

/* Adds fit i to the table of peaks, as its row `kept`. */
static void keep_peak(Workspace *work, int64_t i, int64_t kept)
{
    const float *fit = work->fits + i;
    const int64_t padded = work->padded, width = work->width;
    const float free = max_f32(fit[PIXELS * padded] - 4, 1), chi2 = fit[CHI2 * padded];
    work->peaks[ALONG * width + kept] = work->columns[i];
    work->peaks[ACROSS * width + kept] = work->rows[i] + (double)fit[CENTRE * padded];
    work->peaks[HEIGHT * width + kept] = fit[AMPLITUDE * padded];
    work->peaks[BROAD * width + kept] = fit[SIGMA * padded];
    work->peaks[UNSURE * width + kept] =
        fit[VARIANCE * padded] * (chi2 > MISFIT * free ? chi2 / free : 1);
}

/* Fills the table of peaks with those of n fits that may be a stripe; returns how many. */
static int64_t sift(Workspace *work, int64_t n, double threshold, float saturated)
{
    const double usual = usual_sigma(work, n, saturated);
    if (usual == 0)
        return 0;
    const Limits usually = limits_of(work, usual, threshold, 1);
    const Limits between = limits_of(work, usual, threshold, BETWEEN);
    /* the last fit on which the line goes on, -1 for none, and the last that is as wide as it */
    int64_t kept = 0, before = -1, sure = -1;
    for (int64_t i = 0; i < n; i++) {
        if (!fits_limits(work, &between, i))
            continue;
        const bool goes_on = before >= 0 && follows(work, before, i);
        if (fits_limits(work, &usually, i)) {
            for (int64_t k = goes_on ? sure + 1 : i; k < i; k++)
                if (fits_limits(work, &between, k))
                    keep_peak(work, k, kept++);
            keep_peak(work, i, kept++);
            before = sure = i;
        } else {
            const bool is_near =
                goes_on && work->columns[i] - work->columns[sure] <= LONGEST_BETWEEN;
            before = is_near ? i : -1;
        }
    }
    return kept;
}
