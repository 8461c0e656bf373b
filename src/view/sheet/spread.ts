/** A label on a line: where its middle would stand best, and how much of the line it takes. */
export interface OnLine {
  readonly at: number;
  readonly size: number;
}

/** Rounding of sums: what is smaller is no lack of room. */
const SUM = 1e-9;

/**
 * The middles of labels between `low` and `high`, in their order (rising), none nearer to the next than `gap`, and each
 * as near to where it would stand best as the others let it; null where they have no room. Neighbours that push each
 * other share the way.
 */
export function spread(labels: readonly OnLine[], low: number, high: number, gap: number): readonly number[] | null {
  const [first, last] = [labels[0], labels.at(-1)];
  if (!first || !last) return [];
  // With what stands before each taken off, "no overlap" is "not falling".
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
