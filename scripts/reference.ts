/** Duration of the reference loop on the machine for which limits are stated, ms. */
export const REFERENCE = 4;

/**
 * The reference loop: a fixed amount of arithmetic, typed arrays and ring operations, similar to the proof. A time
 * divided by that of this loop can be compared between machines, and between a quiet and a busy hour of one machine. It
 * uses no outside name, so that it can be sent into a page as text. Returns a number that depends on all of the work,
 * the same every time.
 */
export function referenceWork(): number {
  const [points, cuts, cells] = [600, 40, 20_000];
  let seed = 12_345;
  const next = () => (seed = (seed * 1_103_515_245 + 12_345) % 2_147_483_648) / 2_147_483_648;
  const heights = new Float64Array(cells);
  let ring = Array.from({ length: points }, (_, i) => {
    const angle = (2 * Math.PI * i) / points,
      far = 40 + next();
    return { z: far * Math.cos(angle), r: far * Math.sin(angle) };
  });
  let sum = 0;
  for (let cut = 0; cut < cuts; cut += 1) {
    // Cuts half of the plane from the ring, each time in another direction.
    const angle = 2 * Math.PI * next(),
      [nz, nr] = [Math.cos(angle), Math.sin(angle)],
      limit = 39.5 - cut * 0.1;
    const kept = [];
    for (let i = 0; i < ring.length; i += 1) {
      const a = ring[i] ?? { z: 0, r: 0 },
        b = ring[(i + 1) % ring.length] ?? a;
      const over = a.z * nz + a.r * nr - limit,
        overNext = b.z * nz + b.r * nr - limit;
      if (over <= 0) kept.push(a);
      if (over <= 0 !== overNext <= 0) {
        const part = over / (over - overNext);
        kept.push({ z: a.z + (b.z - a.z) * part, r: a.r + (b.r - a.r) * part });
      }
    }
    ring = kept;
    for (let i = 0; i < ring.length; i += 1) {
      const a = ring[i] ?? { z: 0, r: 0 },
        b = ring[(i + 1) % ring.length] ?? a;
      sum += a.z * b.r - b.z * a.r;
    }
    for (let i = 0; i < cells; i += 1) {
      const z = (i - cells / 2) / 200,
        deep = Math.sqrt(Math.abs(limit * limit - z * z)) * (1 + 0.01 * cut);
      heights[i] = Math.max(heights[i] ?? 0, deep - 0.5 * Math.abs(z));
    }
    for (let i = 1; i < cells; i += 1) sum += Math.abs((heights[i] ?? 0) - (heights[i - 1] ?? 0));
  }
  return sum;
}

/** The median of some numbers; for an even count the mean of the middle two. */
export function middle(numbers: readonly number[]): number {
  const sorted = [...numbers].sort((a, b) => a - b),
    half = sorted.length / 2;
  const [below, above] = [sorted[Math.ceil(half) - 1], sorted[Math.floor(half)]];
  return below === undefined || above === undefined ? Number.NaN : (below + above) / 2;
}

/** Duration of the reference loop in this process, ms: the median of a few rounds. */
export function referenceTime(rounds = 5): number {
  return middle(
    Array.from({ length: rounds }, () => {
      const began = performance.now();
      if (Number.isNaN(referenceWork())) throw new Error("the reference loop went wrong");
      return performance.now() - began;
    }),
  );
}
