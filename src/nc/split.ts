/**
 * The lines of one block: where each starts and where its text ends, before its line end. Offsets over the whole text.
 */
export interface Lines {
  readonly starts: readonly number[];
  readonly ends: readonly number[];
}

/** One block as lines, with number and skip mark. */
export interface Slice {
  /** Offsets over the whole text: the block with its line ends. */
  readonly from: number;
  readonly to: number;
  /** First and last line, indices into `Lines`. */
  readonly first: number;
  readonly last: number;
  readonly number: number | null;
  readonly skip: boolean;
  /** Where the statement starts, behind number and skip mark. */
  readonly body: number;
  /** The last line announces a missing continuation. */
  readonly open: boolean;
}

const isSpace = (c: number) => c === 32 || c === 9 || c === 0xa0 || c === 0xfeff || c === 12 || c === 11;

/** Splits at \r\n, \n and a lone \r. A text that ends with a line end has no empty line behind it. */
export function splitLines(text: string): Lines {
  const starts: number[] = [];
  const ends: number[] = [];
  const pattern = /\r\n|\n|\r/g;
  let start = 0;
  for (let m = pattern.exec(text); m; m = pattern.exec(text)) {
    starts.push(start);
    ends.push(m.index);
    start = pattern.lastIndex;
  }
  if (start < text.length) {
    starts.push(start);
    ends.push(text.length);
  }
  return { starts, ends };
}

const HEAD = /[ \t\u00a0\ufeff]*(\/?)[ \t]*(?:[Nn]?(\d+)(?![\d.,])[ \t\u00a0]*(\/?))?[ \t\u00a0]*/y;
const CYCLE_HEAD = /(?:CYCLE?[ \t]*DEF|TCH[ \t]+PROBE)[ \t]*(?!\d{1,2}[ \t]+\.\d{1,3}(?!\S))\d+(?![\d.])/iy;
const Q_LINE = /[ \t\u00a0]*Q(\d+)[ \t\u00a0]*(?:=|[+-][ \t]*[\d.,])/iy;
const NEW_BLOCK = new RegExp(
  String.raw`[ \t\u00a0\ufeff]*(?:(?:\/[ \t]*)?N?\d+[ \t/]|` +
    String.raw`(?:CYCLE?(?:DEF|CALL)?|BEGIN|END|LBL|CALL|TOOL|BLK|FUNCTION|L|C|CR|CT|CC|RND|CHF|APPR|DEP|STOP|` +
    String.raw`M\d+|SEL|FN|IF|TRANS)(?![A-Z])|\*|;)`,
  "iy",
);

const matchAt = (pattern: RegExp, text: string, at: number): RegExpExecArray | null => {
  pattern.lastIndex = at;
  return pattern.exec(text);
};

/** A number with more digits than a block number can have is none. */
const printed = (digits: string | undefined) => (digits !== undefined && digits.length <= 9 ? Number(digits) : null);

/**
 * The block structure of a text, one block after the other: joined lines, by `~` or, in the older layout, Q lines after
 * their cycle.
 */
export function* splitBlocks(text: string, { starts, ends }: Lines): Generator<Slice> {
  const count = starts.length;
  const blank = (i: number) => {
    for (let k = starts[i] ?? 0; k < (ends[i] ?? 0); k += 1) if (!isSpace(text.charCodeAt(k))) return false;
    return true;
  };
  const tilde = (i: number) => {
    let k = (ends[i] ?? 0) - 1;
    while (k >= (starts[i] ?? 0) && isSpace(text.charCodeAt(k))) k -= 1;
    return k >= (starts[i] ?? 0) && text.charCodeAt(k) === 126;
  };
  const written = (i: number) => {
    while (i < count && blank(i)) i += 1;
    return i;
  };
  const at = (pattern: RegExp, i: number): RegExpExecArray | null => {
    const m = i < count ? matchAt(pattern, text, starts[i] ?? 0) : null;
    return m && pattern.lastIndex <= (ends[i] ?? 0) ? m : null;
  };

  let i = 0;
  while (i < count) {
    const first = i;
    const head = matchAt(HEAD, text, starts[first] ?? 0);
    const numbered = head?.[2] !== undefined;
    const body = Math.min(head ? HEAD.lastIndex : (starts[first] ?? 0), ends[first] ?? 0);
    const cycle = matchAt(CYCLE_HEAD, text, body) !== null;
    let last = first;
    let open = tilde(first);
    let tildes = open;
    // After a list with ` ~`, a line with a blank before the equals sign is a formula: `Q215=+0` is a value, `Q1999 =
    // 25` a block.
    const isValue = (m: RegExpExecArray) => !tildes || !/\d[ \t\u00a0]+=/.test(m[0]);
    const belongs = (m: RegExpExecArray | null, k: number) =>
      m !== null &&
      (numbered || (Number(m[1]) >= 200 && isValue(m)) || (!tildes && text.slice(m.index, ends[k]).includes(";")));
    while (open || cycle) {
      const next = written(last + 1);
      if (next >= count) break;
      if (open) {
        if (at(NEW_BLOCK, next)) break;
        last = next;
      } else if (cycle && belongs(at(Q_LINE, next), next)) {
        last = next;
      } else if (
        cycle &&
        !tildes &&
        !at(NEW_BLOCK, next) &&
        belongs(at(Q_LINE, written(next + 1)), written(next + 1))
      ) {
        last = next; // A name or label that was wrapped when it was copied from a printed page.
      } else break;
      open = tilde(last);
      tildes ||= open;
    }
    i = last + 1;
    yield {
      from: starts[first] ?? 0,
      to: i < count ? (starts[i] ?? text.length) : text.length,
      first,
      last,
      number: numbered ? printed(head?.[2]) : null,
      skip: head?.[1] === "/" || head?.[3] === "/",
      body,
      open,
    };
  }
}
