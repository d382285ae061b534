/* Step 10: keeps the fitted peaks that are as wide and high as a stripe. */

/* Widths, in shares of the picture's usual one, beyond which a peak is no stripe, and the least
 * standard deviation in px. */
static const double NARROW = 0.45, WIDE = 2.2, LEAST_SIGMA_PX = 0.5;
/* The misfit from which on a point is less certain. */
static const float MISFIT = 3;
/* Widths that the usual one is the median of. */
enum { WIDTHS = 63 };

/* The usual width of n fitted peaks; 0 where there is none. */
static float usual_sigma(const Workspace *work, int64_t n)
{
    const float *sigma = work->fits + SIGMA * work->padded;
    const float *became = work->fits + BECAME * work->padded;
    float some[WIDTHS];
    int found = 0;
    for (int64_t i = 0; i < n; i += (n + WIDTHS - 1) / WIDTHS)
        if (became[i] == PEAK)
            some[found++] = sigma[i];
    return found ? median_of(some, found) : 0;
}

/* Fills the table of peaks with those of n fits that may be a stripe; returns how many. */
static int64_t sift(Workspace *work, int64_t n, double threshold)
{
    const double usual = usual_sigma(work, n);
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
