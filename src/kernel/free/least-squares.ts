/** Values at which all residuals vanish or are smallest. */
export interface Fit {
  readonly at: readonly number[];
  /** The largest residual there. */
  readonly rest: number;
  /** False if the values can move in some direction without the residuals growing. */
  readonly isolated: boolean;
}

export type Residuals = (at: readonly number[]) => readonly number[];

const ROUNDS = 60;
/** Smaller steps change nothing, and smaller pivots count as none. */
const STILL = 1e-15;
const FLAT = 1e-7;
/** Step of a finite difference, relative to the value. */
const DIFFERENCE = 1e-6;
const [FIRST_DAMPING, LEAST_DAMPING] = [0.001, STILL];

/** Columns of derivatives by finite differences from the point where the residuals are `here`. */
function slopes(f: Residuals, at: readonly number[], here: readonly number[]): number[][] {
  return at.map((value, i) => {
    const step = DIFFERENCE * Math.max(1, Math.abs(value));
    return f(at.with(i, value + step)).map((there, k) => (there - (here[k] ?? 0)) / step);
  });
}

const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, v, i) => sum + v * (b[i] ?? 0), 0);

/** Solves a small symmetric system by elimination with pivots; null where it has no single solution. */
function eliminated(matrix: readonly (readonly number[])[], right: readonly number[], least: number): number[] | null {
  const n = right.length;
  const rows = matrix.map((row, i) => [...row, right[i] ?? 0]);
  for (let column = 0; column < n; column += 1) {
    let pivot = column;
    for (let i = column + 1; i < n; i += 1)
      if (Math.abs(rows[i]?.[column] ?? 0) > Math.abs(rows[pivot]?.[column] ?? 0)) pivot = i;
    const [head, other] = [rows[pivot], rows[column]];
    const size = head?.[column] ?? 0;
    if (!head || !other || Math.abs(size) <= least) return null;
    [rows[column], rows[pivot]] = [head, other];
    for (let i = 0; i < n; i += 1) {
      const row = rows[i];
      const factor = i === column || !row ? 0 : (row[column] ?? 0) / size;
      if (row && factor !== 0) {
        for (let k = column; k <= n; k += 1) row[k] = (row[k] ?? 0) - factor * (head[k] ?? 0);
      }
    }
  }
  return rows.map((row, i) => (row[n] ?? 0) / (row[i] ?? 1));
}

/** The nearest minimum of the sum of squared residuals, by damped steps from a start (Levenberg and Marquardt). */
export function leastSquares(f: Residuals, start: readonly number[]): Fit {
  let [at, damping]: [readonly number[], number] = [start, FIRST_DAMPING];
  let residuals = f(at);
  let error = dot(residuals, residuals);
  for (let round = 0; round < ROUNDS && error > STILL * STILL; round += 1) {
    const columns = slopes(f, at, residuals);
    const normal = columns.map((a) => columns.map((b) => dot(a, b)));
    const down = columns.map((a) => -dot(a, residuals));
    let moved = false;
    for (let tries = 0; tries < 8 && !moved; tries += 1) {
      const step = eliminated(
        normal.map((row, i) => row.with(i, (row[i] ?? 0) * (1 + damping) + STILL)),
        down,
        0,
      );
      const next = step && at.map((v, i) => v + (step[i] ?? 0));
      const found = next && f(next);
      const less = found ? dot(found, found) : Infinity;
      if (next && found && less < error) {
        moved = error - less > STILL * error;
        [at, residuals, error] = [next, found, less];
        damping = Math.max(LEAST_DAMPING, damping / 8);
        if (!moved) break;
      } else damping *= 6;
    }
    if (!moved) break;
  }
  const columns = slopes(f, at, residuals);
  const isolated =
    eliminated(
      columns.map((a) => columns.map((b) => dot(a, b))),
      columns.map(() => 0),
      FLAT * FLAT,
    ) !== null;
  return { at, rest: residuals.reduce((most, r) => Math.max(most, Math.abs(r)), 0), isolated };
}
