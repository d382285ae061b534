/* Step 10: keeps the fitted peaks that are as wide and high as a stripe. */

/* Widths, in shares of the picture's usual one, beyond which a peak is no stripe, and the least
 * standard deviation in px. */
static const double NARROW = 0.45, WIDE = 2.2, LEAST_SIGMA_PX = 0.5;
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

/* Whether fit i continues the piece that fit i - 1 belongs to. */
static bool continues(const Workspace *work, int64_t i)
{
    const float *centre = work->fits + CENTRE * work->padded;
    const int32_t gap = work->columns[i] - work->columns[i - 1];
    const double rise = work->rows[i] - work->rows[i - 1] + (double)centre[i] - centre[i - 1];
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
        } else if (i + 1 == n || became[i + 1] != PEAK || !continues(work, i + 1)) {
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

/* Fills the table of peaks with those of n fits that may be a stripe; returns how many. */
static int64_t sift(Workspace *work, int64_t n, double threshold, float saturated)
{
    const double usual = usual_sigma(work, n, saturated);
    if (usual == 0)
        return 0;
    const double narrowest =
        isnan(work->narrowest_px) ? max_f64(NARROW * usual, LEAST_SIGMA_PX) : work->narrowest_px;
    const double widest =
        isnan(work->widest_px) ? max_f64(WIDE * usual, narrowest) : work->widest_px;
    const float *fit[FIT_ROWS];
    double *peak[PEAK_ROWS];
    for (int row = 0; row < FIT_ROWS; row++)
        fit[row] = work->fits + row * work->padded;
    for (int row = 0; row < PEAK_ROWS; row++)
        peak[row] = work->peaks + row * work->width;
    int64_t kept = 0;
    for (int64_t i = 0; i < n; i++) {
        const double sigma = fit[SIGMA][i];
        if (fit[BECAME][i] != PEAK || !(narrowest < sigma && sigma < widest))
            continue;
        if (fit[AMPLITUDE][i] < threshold)
            continue;
        const float free = max_f32(fit[PIXELS][i] - 4, 1), chi2 = fit[CHI2][i];
        peak[ALONG][kept] = work->columns[i];
        peak[ACROSS][kept] = work->rows[i] + (double)fit[CENTRE][i];
        peak[HEIGHT][kept] = fit[AMPLITUDE][i];
        peak[BROAD][kept] = sigma;
        peak[UNSURE][kept] = fit[VARIANCE][i] * (chi2 > MISFIT * free ? chi2 / free : 1);
        kept++;
    }
    return kept;
}
