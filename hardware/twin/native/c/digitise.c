/* Digits of a frame (height, width) from its light, with noise; saturates.
 *
 * noise.c includes this for each kind of digits: PIXEL is the type, OF(name) its function's name.
 *
 * pool (pool_size) of normal deviates, offsets (height) where each row's begin in it; gain: 8-bit
 * digits per unit of light. All in 8-bit digits: dark level and haze, read noise, variance of the
 * shot noise per digit, the largest value; scale: from 8-bit digits to the detector's own. */
EXPORT(void, OF(digitise))(int64_t height, int64_t width, int64_t pool_size, const float *light,
                           const float *pool, const int64_t *offsets, double gain, double dark,
                           double haze, double read, double shot, double top, double scale,
                           PIXEL *out)
{
    (void)pool_size;
    double read2 = read * read;
    for (int64_t r = 0; r < height; r++) {
        const float *row = light + r * width, *normal = pool + offsets[r];
        PIXEL *digits = out + r * width;
        for (int64_t c = 0; c < width; c++) {
            double signal = row[c] * (float)gain + haze;
            double value = dark + signal + sqrt(read2 + shot * signal) * normal[c];
            digits[c] = (PIXEL)(int32_t)(min_f64(max_f64(value, 0.0), top) * scale + 0.5);
        }
    }
}
