/* Step 4: chooses one peak a column, by a rule; by the tracks that peaks lie on where a column
 * has several in question. */

/* Columns that a track may skip; the rows of peaks are known to COARSE. */
enum { SKIP = 3, COARSE = 3 };
/* A track counts by how high it is on average; in full if it has this many peaks, else by the
 * square of its share of them. */
enum { LONG_TRACK = 40 };
/* Lower than this share of a column's highest peak, none is in question. */
static const double RIVAL = 0.2;
/* What sets tracks long enough apart from others, under the rules by order. */
static const double LONG_ENOUGH = 1e6;

/* Fills the highest peak of each column, the first of equals, -1 for none; whether any column has
 * a second one that is at least a `share` as high. */
static bool find_highest(Workspace *work, int64_t n, double share)
{
    int32_t *best = work->best, *second = work->second;
    for (int64_t i = 0; i < work->width; i++)
        best[i] = second[i] = -1;
    for (int64_t p = 0; p < n; p++) {
        const int32_t column = work->peak_columns[p], before = best[column];
        const int32_t height = work->peak_heights[p];
        if (before < 0) {
            best[column] = (int32_t)p;
        } else if (height > work->peak_heights[before]) {
            best[column] = (int32_t)p;
            second[column] = work->peak_heights[before];
        } else if (height > second[column]) {
            second[column] = height;
        }
    }
    for (int64_t i = 0; i < work->width; i++)
        if (second[i] >= 0 && second[i] >= share * work->peak_heights[best[i]])
            return true;
    return false;
}

/* Sorts peaks by columns: fills where each column's begin, and their order, in each column as
 * they came. */
static void sort_by_columns(Workspace *work, int64_t n)
{
    int32_t *begin = work->begin;
    const int64_t width = work->width;
    memset(begin, 0, (size_t)(width + 1) * sizeof *begin);
    for (int64_t p = 0; p < n; p++)
        begin[work->peak_columns[p] + 1]++;
    for (int64_t i = 0; i < width; i++)
        begin[i + 1] += begin[i];
    for (int64_t p = 0; p < n; p++)
        work->track_order[begin[work->peak_columns[p]]++] = (int32_t)p;
    for (int64_t i = width; i > 0; i--)
        begin[i] = begin[i - 1];
    begin[0] = 0;
}

/* The nearest earlier peak that peak p of column i may follow and no peak of i does; -1: none. */
static int32_t predecessor(const Workspace *work, int32_t p, int64_t i)
{
    for (int64_t back = 1; back <= min_i64(SKIP, i); back++) {
        int32_t best = -1, nearest = INT32_MAX;
        for (int32_t at = work->begin[i - back]; at < work->begin[i - back + 1]; at++) {
            const int32_t q = work->track_order[at];
            const int32_t rise = work->peak_rows[p] - work->peak_rows[q];
            const int32_t climb = rise < 0 ? -rise : rise;
            const bool free = work->reached[work->track[q]] != i;
            if (climb <= work->climb * (double)back + COARSE && climb < nearest && free) {
                nearest = climb;
                best = q;
            }
        }
        if (best >= 0)
            return best;
    }
    return -1;
}

/* Numbers the peaks so that those that follow one another share a track; returns how many. */
static int64_t link_tracks(Workspace *work, int64_t n)
{
    int64_t tracks = 0;
    memset(work->reached, -1, (size_t)n * sizeof *work->reached);
    for (int64_t i = 0; i < work->width; i++) {
        for (int32_t at = work->begin[i]; at < work->begin[i + 1]; at++) {
            const int32_t p = work->track_order[at], before = predecessor(work, p, i);
            work->track[p] = before >= 0 ? work->track[before] : (int32_t)tracks++;
            work->reached[work->track[p]] = (int32_t)i;
        }
    }
    return tracks;
}

/* What each peak is worth by its track and the rule; the worthiest of a column is chosen. */
static void weigh_tracks(Workspace *work, int64_t n, int64_t tracks)
{
    memset(work->track_total, 0, (size_t)tracks * sizeof *work->track_total);
    memset(work->track_count, 0, (size_t)tracks * sizeof *work->track_count);
    for (int64_t p = 0; p < n; p++) {
        work->track_total[work->track[p]] += work->peak_heights[p];
        work->track_count[work->track[p]]++;
    }
    for (int64_t p = 0; p < n; p++) {
        const int32_t length = work->track_count[work->track[p]];
        if (work->rule == CONTINUITY) {
            const double share = min_f64((double)length / LONG_TRACK, 1);
            work->worth[p] = work->track_total[work->track[p]] / length * share * share;
        } else { /* a short track is taken where there is no other */
            const double down = work->rule == LAST ? work->peak_rows[p] : -work->peak_rows[p];
            work->worth[p] = down + (length >= work->shortest_run ? LONG_ENOUGH : -LONG_ENOUGH);
        }
    }
}

/* Chooses the best of n peaks for every column; whether the peaks have got tracks. */
static bool choose_peaks(Workspace *work, int64_t n)
{
    const double share = work->rule == CONTINUITY ? RIVAL : 0;
    if (!find_highest(work, n, share) || work->rule == STRENGTH)
        return false;
    sort_by_columns(work, n);
    weigh_tracks(work, n, link_tracks(work, n));
    for (int64_t i = 0; i < work->width; i++) {
        for (int32_t at = work->begin[i]; at < work->begin[i + 1]; at++) {
            const int32_t p = work->track_order[at];
            if (at == work->begin[i] || work->worth[p] > work->worth[work->best[i]])
                work->best[i] = p;
        }
    }
    return true;
}

/* Fills columns and rows of the chosen peaks, in ascending order of columns; returns how many.
 *
 * without (n): columns to leave out, in ascending order. */
static int64_t list_chosen(Workspace *work, const int32_t *without, int64_t n)
{
    int64_t found = 0, left_out = 0;
    for (int64_t i = 0; i < work->width; i++) {
        if (left_out < n && without[left_out] == i) {
            left_out++;
        } else if (work->best[i] >= 0) {
            work->columns[found] = (int32_t)i;
            work->rows[found++] = work->peak_rows[work->best[i]];
        }
    }
    return found;
}
