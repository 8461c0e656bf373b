/** A label on a line: the preferred place of its middle, and the length it takes. */
export interface OnLine {
  readonly at: number;
  readonly size: number;
}

/** Rounding of sums: a smaller overlap is no lack of room. */
const SUM = 1e-9;

/**
 * The middles of labels between `low` and `high`, in their order (rising), none nearer to the next than `gap`, and each
 * as near to its preferred place as the others allow; null if they do not fit. Neighbours that push each other share
 * the shift.
 */
export function spread(labels: readonly OnLine[], low: number, high: number, gap: number): readonly number[] | null {
  const [first, last] = [labels[0], labels.at(-1)];
  if (!first || !last) return [];
  // With the space of all earlier labels subtracted, "no overlap" becomes "not falling".
  let behind = 0;
  const before = labels.map(({ size }, i) => {
    const previous = labels[i - 1];
    if (previous) behind += (previous.size + size) / 2 + gap;
    return behind;
  });
  const [least, most] = [low + first.size / 2, high - last.size / 2 - behind];
  if (least > most + SUM) return null;
  const blocks: { sum: number; count: number }[] = [];
  for (const [i, { at }] of labels.entries()) {
    let block = { sum: at - (before[i] ?? 0), count: 1 };
    for (let top = blocks.at(-1); top && top.sum / top.count > block.sum / block.count; top = blocks.at(-1)) {
      block = { sum: block.sum + top.sum, count: block.count + top.count };
      blocks.pop();
    }
    blocks.push(block);
  }
  const level = blocks.flatMap(({ sum, count }) =>
    Array.from({ length: count }, () => Math.min(Math.max(sum / count, least), most)),
  );
  return level.map((value, i) => value + (before[i] ?? 0));
}

/** As many texts as find a place, laid out; those of the lowest rank, the last, are left out first. Null if none does. */
export function mostThatFit<T, L>(ranked: readonly T[], lay: (some: readonly T[]) => L | null): L | null {
  for (let n = ranked.length; n > 0; n -= 1) {
    const laid = lay(ranked.slice(0, n));
    if (laid) return laid;
  }
  return null;
}
