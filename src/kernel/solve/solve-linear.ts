/** A number that depends linearly on free parameters: constant + sum of factor times parameter. */
export interface Affine {
  readonly constant: number;
  readonly by: ReadonlyMap<number, number>;
}

/** Sum of factor times variable equals value. Factors are of the order of 1, values in mm. */
export interface Equation {
  readonly terms: readonly (readonly [variable: number, factor: number])[];
  readonly value: number;
}

/** Smaller factors are rounding errors: two directions nearer than this, in radians, are the same. */
const NO_FACTOR = 1e-7;

export const constantForm = (constant: number): Affine => ({ constant, by: new Map() });

interface Row {
  readonly factors: Map<number, number>;
  value: number;
}

function subtract(row: Row, other: Row, times: number): void {
  for (const [variable, factor] of other.factors) {
    const left = (row.factors.get(variable) ?? 0) - factor * times;
    if (Math.abs(left) < NO_FACTOR) row.factors.delete(variable);
    else row.factors.set(variable, left);
  }
  row.value -= other.value * times;
}

/**
 * Solves all variables that the equations determine; each is returned as a constant, or as a function of the variables
 * that stay free (numbered from `first`). An equation that repeats or contradicts earlier ones is left out.
 */
export function solveLinear(count: number, equations: readonly Equation[], first = 0): Affine[] {
  const rows = new Map<number, Row>();
  for (const { terms, value } of equations) {
    const row: Row = { factors: new Map(), value };
    for (const [variable, factor] of terms) subtract(row, { factors: new Map([[variable, factor]]), value: 0 }, -1);
    for (const variable of [...row.factors.keys()]) {
      const pivot = rows.get(variable),
        factor = row.factors.get(variable);
      if (pivot && factor !== undefined) subtract(row, pivot, factor);
    }
    let best: number | null = null;
    for (const [variable, factor] of row.factors)
      if (best === null || Math.abs(factor) > Math.abs(row.factors.get(best) ?? 0)) best = variable;
    if (best === null) continue;
    const scale = row.factors.get(best) ?? 1;
    row.factors.forEach((factor, variable) => row.factors.set(variable, factor / scale));
    row.value /= scale;
    for (const other of rows.values()) {
      const factor = other.factors.get(best);
      if (factor !== undefined) subtract(other, row, factor);
    }
    rows.set(best, row);
  }
  return Array.from({ length: count }, (_, variable): Affine => {
    const row = rows.get(variable);
    if (!row) return { constant: 0, by: new Map([[first + variable, 1]]) };
    const by = new Map<number, number>();
    for (const [other, factor] of row.factors) if (other !== variable) by.set(first + other, -factor);
    return { constant: row.value, by };
  });
}
