/* The median and other quantiles of a few numbers. */

/* The value that `wanted` others are not above; reorders the values (n > wanted). */
static float nth_of(float *values, int64_t n, int64_t wanted)
{
    int64_t low = 0, high = n - 1;
    while (low < high) {
        float pivot = values[(low + high) / 2];
        int64_t i = low, j = high;
        while (i <= j) {
            while (values[i] < pivot)
                i++;
            while (pivot < values[j])
                j--;
            if (i <= j) {
                float swapped = values[i];
                values[i++] = values[j];
                values[j--] = swapped;
            }
        }
        if (wanted <= j)
            high = j;
        else if (wanted >= i)
            low = i;
        else
            break;
    }
    return values[wanted];
}

/* Reorders the values (n > 0); the upper one of two in the middle. */
static float median_of(float *values, int64_t n) { return nth_of(values, n, n / 2); }
