/* Step 13: which pieces are the line, and whether there is one.
 *
 * What stands out beside the line in its columns, the clutter, shows what a piece by itself may
 * be: none of the line unless it is brighter, or the line goes on in it. A piece whose track goes
 * on beneath a stronger piece is a reflection, a ghost. */

/* A peak so many rows from a point is another one; so few, the same. */
enum { BESIDE_LINE = 20, ON_LINE = 8 };
/* A piece is a main one if it has this share of the strongest one's light, or some of it and this
 * share of its height. Where they have less than a share of the columns, all columns show clutter. */
static const double MAIN = 0.3, MAIN_LIGHT = 0.03, MAIN_HEIGHT = 0.6, MAIN_COLUMNS = 0.3;
/* The share of columns that have no more clutter than is counted; how far above it a piece by
 * itself is line. */
static const double CLUTTER_SHARE = 0.9, ABOVE_CLUTTER = 1.3;
/* A dimmer one is, too, with this share of the main pieces' height, and less clutter than this. */
static const double HARDLY_LESS = 0.3, ALONE = 0.5;
/* The line goes on over so many columns, climbing as in a run, and by so many rows at once. */
enum { BRIDGED = 16, STEP_ROWS = 8 };
/* Columns in which a ghost's track lies beneath the line, at least, and in shares of those in
 * which it does not; its height there in shares of the line's, and of its own where it does not: a
 * reflection does not fade where the line begins, what a track of the line is linked to may. */
static const double GHOST_COLUMNS = 12, GHOST_SHARE = 0.5, GHOST_HEIGHT = 0.7, GHOST_FADES = 0.5;

/* Lists the pieces of n points; returns how many. */
static int64_t list_pieces(Workspace *work, int64_t n)
{
    Piece *pieces = work->pieces;
    const double *along = work->points, *across = along + ACROSS * work->width;
    const double *height = along + HEIGHT * work->width;
    int64_t found = 0, begin = 0;
    double light = 0;
    for (int64_t i = 0; i < n; i++) {
        light += height[i];
        if (i + 1 < n &&
            run_goes_on(along[i + 1] - along[i], across[i + 1] - across[i], work->climb))
            continue;
        const int64_t count = i + 1 - begin;
        pieces[found++] = (Piece){begin, count, light / (double)count, true, TAKEN_MAIN};
        begin = i + 1;
        light = 0;
    }
    return found;
}

/* How many points n pieces have, of which the last one's are the last. */
static int64_t count_points(const Workspace *work, int64_t n)
{
    return n ? work->pieces[n - 1].begin + work->pieces[n - 1].count : 0;
}

/* Fills which point each column has (width), -1 for none: points of the kept ones of n pieces. */
static void list_points(const Workspace *work, int64_t n, int32_t *point_at)
{
    memset(point_at, -1, (size_t)work->width * sizeof *point_at);
    for (const Piece *piece = work->pieces; piece < work->pieces + n; piece++)
        for (int64_t i = piece->begin; piece->kept && i < piece->begin + piece->count; i++)
            point_at[(int64_t)work->points[i]] = (int32_t)i;
}

/* How many rows a peak is from its column's point. */
static double rows_between(const Workspace *work, int32_t peak, int32_t point)
{
    return fabs(work->points[ACROSS * work->width + point] - work->peak_rows[peak]);
}

/* Fills the height of the clutter in each column (width): its highest peak beside the line, by n
 * peaks; returns how many peaks are clutter. `bridge` has the line's row in columns without a point
 * (width), negative where it is not known; or is null. */
static int64_t find_clutter(Workspace *work, int64_t n, const int32_t *point_at,
                            const float *bridge)
{
    float *highest = work->clutter;
    int64_t found = 0;
    memset(highest, 0, (size_t)work->width * sizeof *highest);
    for (int64_t p = 0; p < n; p++) {
        const int32_t column = work->peak_columns[p], point = point_at[column];
        if (point >= 0 && rows_between(work, (int32_t)p, point) <= BESIDE_LINE)
            continue;
        if (point < 0 && bridge && bridge[column] >= 0 &&
            fabs((double)bridge[column] - work->peak_rows[p]) <= BESIDE_LINE)
            continue;
        highest[column] = max_f32(highest[column], (float)work->peak_heights[p]);
        found++;
    }
    return found;
}

/* What the clutter in most columns from `begin` on and before `behind` is at most, in shares of the
 * line's height: there, or `height` where it has no point; such columns count if that is given. */
static double clutter_level(const Workspace *work, const int32_t *point_at, int64_t begin,
                            int64_t behind, double height)
{
    const double *heights = work->points + HEIGHT * work->width;
    int64_t found = 0;
    for (int64_t i = begin; i < behind; i++) {
        const double line = point_at[i] >= 0 ? heights[point_at[i]] : height;
        if (line > 0)
            work->levels[found++] = work->clutter[i] / (float)line;
    }
    return found ? nth_of(work->levels, found, (int64_t)(CLUTTER_SHARE * (double)found)) : 0;
}

/* Counts in how many columns each track is the point, and in how many it lies beside one that is
 * stronger: work->reached and work->track_order; and sums its heights there: work->track_total and
 * work->worth. */
static void count_columns(Workspace *work, int64_t n, const int32_t *point_at)
{
    int32_t *chosen = work->reached, *beneath = work->track_order;
    double *chosen_height = work->track_total, *beneath_height = work->worth;
    const double *height = work->points + HEIGHT * work->width;
    memset(chosen, 0, (size_t)n * sizeof *chosen);
    memset(beneath, 0, (size_t)n * sizeof *beneath);
    memset(chosen_height, 0, (size_t)n * sizeof *chosen_height);
    memset(beneath_height, 0, (size_t)n * sizeof *beneath_height);
    for (int64_t p = 0; p < n; p++) {
        const int32_t point = point_at[work->peak_columns[p]], track = work->track[p];
        if (point < 0)
            continue;
        const double rows = rows_between(work, (int32_t)p, point);
        const double own = work->peak_heights[p];
        if (rows <= ON_LINE) {
            chosen[track]++;
            chosen_height[track] += own;
        } else if (rows > BESIDE_LINE && own < GHOST_HEIGHT * height[point]) {
            beneath[track]++;
            beneath_height[track] += own;
        }
    }
}

/* Whether the tracks that a piece lies on go on beneath stronger pieces. */
static bool is_ghost(const Workspace *work, const Piece *piece)
{
    double chosen = 0, beneath = 0;
    for (int64_t i = piece->begin; i < piece->begin + piece->count; i++) {
        const int32_t peak = work->best[(int64_t)work->points[i]];
        if (peak < 0 || rows_between(work, peak, (int32_t)i) > ON_LINE)
            continue;
        const int32_t track = work->track[peak];
        const double columns = work->reached[track], others = work->track_order[track];
        chosen += columns;
        if (work->worth[track] * columns >= GHOST_FADES * work->track_total[track] * others)
            beneath += others;
    }
    return beneath > GHOST_COLUMNS * (double)piece->count && beneath > GHOST_SHARE * chosen;
}

/* Whether the line goes on from one piece to the next. */
static bool goes_on_in(const Workspace *work, const Piece *piece, const Piece *next)
{
    const double *along = work->points, *across = along + ACROSS * work->width;
    const int64_t end = piece->begin + piece->count - 1;
    const double gap = along[next->begin] - along[end];
    return gap <= BRIDGED &&
           fabs(across[next->begin] - across[end]) <= work->climb * gap + STEP_ROWS;
}

/* Fills the row of the line (width) in the gaps between `count` pieces, where the line has as many
 * points before the gap, and behind it, and climbs no more there than in a run; -1 elsewhere. */
static void bridge_gaps(const Workspace *work, int64_t count, float *bridge)
{
    const Piece *pieces = work->pieces;
    const double *along = work->points, *across = along + ACROSS * work->width;
    const int64_t points = count_points(work, count);
    for (int64_t i = 0; i < work->width; i++)
        bridge[i] = -1;
    for (int64_t k = 1; k < count; k++) {
        const int64_t end = pieces[k].begin - 1, next = pieces[k].begin;
        const double gap = along[next] - along[end], rise = across[next] - across[end];
        if (gap > (double)min_i64(next, points - next) ||
            fabs(rise) > work->climb * gap + STEP_ROWS)
            continue;
        for (int64_t i = 1; i < (int64_t)gap; i++)
            bridge[(int64_t)along[end] + i] = (float)(across[end] + rise * (double)i / gap);
    }
}

/* Keeps a piece, for this reason if it was not kept before. */
static void take_piece(Piece *piece, int32_t why)
{
    piece->why = piece->kept ? piece->why : why;
    piece->kept = true;
}

/* Keeps the pieces in which the line goes on from kept ones. */
static void keep_continued(const Workspace *work, Piece *pieces, int64_t n)
{
    for (int64_t k = 1; k < n; k++)
        if (pieces[k - 1].kept && goes_on_in(work, &pieces[k - 1], &pieces[k]))
            take_piece(&pieces[k], TAKEN_ON);
    for (int64_t k = n - 1; k > 0; k--)
        if (pieces[k].kept && goes_on_in(work, &pieces[k - 1], &pieces[k]))
            take_piece(&pieces[k - 1], TAKEN_ON);
}

static double light_of(const Piece *piece) { return (double)piece->count * piece->height; }

/* Marks the main pieces; fills their mean height and returns how many points they have. */
static int64_t keep_main(Piece *pieces, int64_t n, double *height)
{
    const Piece *strongest = pieces;
    double light = 0;
    int64_t points = 0;
    for (int64_t k = 1; k < n; k++)
        if (light_of(&pieces[k]) > light_of(strongest))
            strongest = &pieces[k];
    for (int64_t k = 0; k < n; k++) {
        const double share = light_of(&pieces[k]) / light_of(strongest);
        pieces[k].kept = share >= MAIN || (share >= MAIN_LIGHT &&
                                           pieces[k].height >= MAIN_HEIGHT * strongest->height);
        pieces[k].why = pieces[k].kept ? TAKEN_MAIN : LEFT_DIM;
        light += pieces[k].kept ? light_of(&pieces[k]) : 0;
        points += pieces[k].kept ? pieces[k].count : 0;
    }
    *height = light / (double)points;
    return points;
}

/* Lists points as left, with what leaves them. */
static void leave_points(Workspace *work, int64_t begin, int64_t count, int32_t why)
{
    double *left = work->scratch;
    for (int64_t i = begin; i < begin + count; i++) {
        left[work->left] = work->points[i];
        left[work->width + work->left] = work->points[ACROSS * work->width + i];
        work->rows[work->width - ++work->left] = why;
    }
}

/* Fills why each point of n pieces is taken: work->rows. */
static void list_reasons(Workspace *work, int64_t n)
{
    for (const Piece *piece = work->pieces; piece < work->pieces + n; piece++)
        for (int64_t i = piece->begin; i < piece->begin + piece->count; i++)
            work->rows[i] = piece->why;
}

/* Moves kept pieces and their points to the front, and lists the others as left; returns how many
 * pieces. */
static int64_t pack_pieces(Workspace *work, int64_t n)
{
    Piece *pieces = work->pieces;
    int64_t kept = 0, found = 0;
    for (int64_t k = 0; k < n; k++) {
        if (!pieces[k].kept) {
            leave_points(work, pieces[k].begin, pieces[k].count, pieces[k].why);
            continue;
        }
        for (int row = ALONG; row <= UNSURE; row++) {
            double *values = work->points + row * work->width;
            memmove(values + found, values + pieces[k].begin,
                    (size_t)pieces[k].count * sizeof *values);
        }
        pieces[kept] = pieces[k];
        pieces[kept++].begin = found;
        found += pieces[k].count;
    }
    return kept;
}

/* Whether a piece by itself is line: brighter than the clutter beside the main pieces, `least`, or
 * long, hardly less bright than they are, and alone in its columns. */
static bool is_bright(const Workspace *work, const Piece *piece, const int32_t *point_at,
                      double least, double height)
{
    if (piece->height > least)
        return true;
    const int64_t begin = (int64_t)work->points[piece->begin];
    const int64_t behind = (int64_t)work->points[piece->begin + piece->count - 1] + 1;
    return piece->count >= LONG_TRACK && piece->height > HARDLY_LESS * height &&
           clutter_level(work, point_at, begin, behind, piece->height) < ALONE;
}

/* Keeps those of `count` pieces that are the line's, by n peaks; returns how many. */
static int64_t keep_line(Workspace *work, int64_t count, int64_t n, bool linked)
{
    Piece *pieces = work->pieces;
    int32_t *point_at = work->columns, *main_at = work->rows;
    if (count < 2)
        return count;
    list_points(work, count, point_at);
    if (linked)
        count_columns(work, n, point_at);
    double height;
    const int64_t points = keep_main(pieces, count, &height);
    list_points(work, count, main_at);
    /* the pieces in question are themselves clutter, as far as a short line shows */
    const bool everywhere = (double)points < MAIN_COLUMNS * (double)work->width;
    find_clutter(work, n, everywhere ? main_at : point_at, NULL);
    const double least = ABOVE_CLUTTER * height *
                         clutter_level(work, main_at, 0, work->width, everywhere ? height : 0);
    if (everywhere)
        find_clutter(work, n, point_at, NULL);
    for (int64_t k = 0; k < count; k++)
        if (is_bright(work, &pieces[k], point_at, least, height))
            take_piece(&pieces[k], TAKEN_BRIGHT);
    keep_continued(work, pieces, count);
    for (int64_t k = 0; linked && k < count; k++)
        if (pieces[k].kept && is_ghost(work, &pieces[k])) {
            pieces[k].kept = false;
            pieces[k].why = LEFT_GHOST;
        }
    return pack_pieces(work, count);
}
