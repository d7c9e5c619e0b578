// The discrete Fourier transform of a power of two of complex numbers, in place.

/** sum over k of x_k exp(+2 pi i j k / N), without a factor: real and imaginary parts in two arrays of length N. */
export function inverseTransform(re, im) {
  const size = re.length;
  for (let i = 1, j = 0; i < size; i++) {
    let bit = size >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) { [re[i], re[j]] = [re[j], re[i]]; [im[i], im[j]] = [im[j], im[i]]; }
  }
  const cosines = new Float64Array(size / 2), sines = new Float64Array(size / 2);
  for (let k = 0; k < size / 2; k++) {
    cosines[k] = Math.cos((2 * Math.PI * k) / size);
    sines[k] = Math.sin((2 * Math.PI * k) / size);
  }
  for (let length = 2; length <= size; length <<= 1) {
    const half = length >> 1, stride = size / length;
    for (let start = 0; start < size; start += length) {
      for (let k = 0; k < half; k++) {
        const low = start + k, high = low + half, c = cosines[k * stride], s = sines[k * stride];
        const x = re[high] * c - im[high] * s, y = re[high] * s + im[high] * c;
        re[high] = re[low] - x; im[high] = im[low] - y;
        re[low] += x; im[low] += y;
      }
    }
  }
}
