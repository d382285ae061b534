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
    /* single precision, for it is twice as quick and 16 bits fit into it */
    const float by = (float)gain, veil = (float)haze, level = (float)dark, most = (float)top;
    const float read2 = (float)(read * read), by_digit = (float)shot, to_own = (float)scale;
    for (int64_t r = 0; r < height; r++) {
        const float *row = light + r * width, *normal = pool + offsets[r];
        PIXEL *digits = out + r * width;
        for (int64_t c = 0; c < width; c++) {
            float signal = row[c] * by + veil;
            float value = level + signal + sqrtf(read2 + by_digit * signal) * normal[c];
            digits[c] = (PIXEL)(int32_t)(min_f32(max_f32(value, 0.0f), most) * to_own + 0.5f);
        }
    }
}
