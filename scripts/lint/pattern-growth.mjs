import { RegExpParser } from "@eslint-community/regexpp";

/**
 * Whether the time of a pattern can grow faster than its text.
 *
 * The pattern becomes an automaton that reads one character at each step. Where two threads p and q of it read the same
 * text v as p → p, p → q and q → q, a text of n times v leaves n ways to cross from p to q, and a backtracking engine
 * tries them all if what follows fails. A search that may begin anywhere is such a p of its own: `/\s+$/` begins at every
 * blank and reads all blanks behind it.
 */

/** Repeats up to this number are written out; a larger one counts as without bound. */
const WRITTEN_OUT = 32;
/** Sets of threads that are followed when it is asked whether a text can fail. */
const MOST_SETS = 400;
const END = -1;
/** No character in front: the start of the text. */
const START = -1;

/** Characters that stand for all: what the sets of patterns tell apart, and one of each usual script. */
const SAMPLE = [
  ...Array.from({ length: 128 }, (_, code) => String.fromCharCode(code)),
  ..."\u00a0\u00e9\u00c4\u00b7\u2028\u2032\u00d7\u2300\u2212\u2013\u4e2d\uff1d\uff08\ufeff\u0301\u03c3",
];

/** Text that makes the time of a pattern grow faster than its length when it is repeated; null for a linear one. */
export function growthOf(source, flags) {
  const pattern = new RegExpParser({ ecmaVersion: 2025 }).parsePattern(source, 0, source.length, {
    unicode: flags.includes("u"),
    unicodeSets: flags.includes("v"),
  });
  if (!/[*+{]/.test(source)) return null;
  return new Automaton(pattern, flags).growth();
}

class Automaton {
  constructor(pattern, flags) {
    this.flags = flags.replace(/[gyd]/g, "");
    this.multiline = flags.includes("m");
    this.sticky = flags.includes("y");
    /** Of each node: steps that read nothing, as {to, assert}, and steps that read one character of a set. */
    this.free = [];
    this.reads = [];
    this.sets = [];
    this.setOf = new Map();
    this.trouble = null;
    this.begin = this.node();
    this.accept = this.node();
    this.link(this.alternatives(pattern.alternatives, this.begin), this.accept);
    this.alphabet(pattern.raw);
  }

  node() {
    this.free.push([]);
    this.reads.push([]);
    return this.free.length - 1;
  }

  link(from, to, assert = null) {
    this.free[from].push({ to, assert });
  }

  /** Number of the set of characters that this piece of a pattern stands for. */
  set(raw) {
    let found = this.setOf.get(raw);
    if (found === undefined) {
      found = this.sets.length;
      const test = new RegExp(`^(?:${raw})$`, this.flags.replace("m", ""));
      this.sets.push((char) => test.test(char));
      this.setOf.set(raw, found);
    }
    return found;
  }

  alternatives(all, from) {
    const out = this.node();
    for (const alternative of all) {
      let at = from;
      for (const element of alternative.elements) at = this.element(element, at);
      this.link(at, out);
    }
    return out;
  }

  element(element, from) {
    switch (element.type) {
      case "Group":
      case "CapturingGroup":
        return this.alternatives(element.alternatives, from);
      case "Quantifier":
        return this.repeat(element, from);
      case "Assertion":
        return this.assertion(element, from);
      case "Backreference":
        return from;
      default: {
        const to = this.node();
        this.reads[from].push({ to, set: this.set(element.raw) });
        return to;
      }
    }
  }

  repeat({ element, min, max, raw }, from) {
    let at = from;
    const unbounded = max > WRITTEN_OUT;
    for (let count = 0; count < Math.min(min, WRITTEN_OUT); count++) at = this.element(element, at);
    if (unbounded) {
      if (nullable(element) && endless(element)) this.trouble ??= raw;
      const head = this.node();
      this.link(at, head);
      const behind = this.element(element, head);
      this.link(behind, head);
      return head;
    }
    const out = this.node();
    this.link(at, out);
    for (let count = min; count < max; count++) {
      at = this.element(element, at);
      this.link(at, out);
    }
    return out;
  }

  assertion(assertion, from) {
    const to = this.node();
    if (assertion.kind === "lookahead" || assertion.kind === "lookbehind") {
      const first = singles(assertion.alternatives);
      const whole = first !== null;
      const sets = (first ?? firsts(assertion.alternatives)).map((raw) => this.set(raw));
      this.link(from, to, { kind: assertion.kind, negate: assertion.negate, whole, sets });
      if (assertion.kind === "lookahead") this.alternatives(assertion.alternatives, from);
      else if (assertion.alternatives.some((each) => each.elements.some(endless))) this.trouble ??= assertion.raw;
    } else {
      this.link(from, to, { kind: assertion.kind, negate: assertion.negate });
    }
    return to;
  }

  /** Characters that no set and no assertion tells apart become one symbol. */
  alphabet(raw) {
    const named = new Set([...SAMPLE, ...raw]);
    for (const char of raw) {
      named.add(char.toLowerCase());
      named.add(char.toUpperCase());
    }
    const symbols = new Map();
    for (const char of named) {
      const word = /\w/.test(char);
      const newline = /[\n\r\u2028\u2029]/.test(char);
      const of = this.sets.map((has) => has(char));
      const key = `${word} ${newline} ${of.join(" ")}`;
      const before = symbols.get(key);
      if (!before || (before.char < "!" && char >= "!" && char <= "~")) symbols.set(key, { char, word, newline, of });
    }
    this.symbols = [...symbols.values()];
  }

  /** Whether an assertion holds between two symbols: for sure, or (`sure` false) at least perhaps. */
  holds({ kind, negate, sets, whole }, before, next, sure) {
    const symbol = (at) => (at < 0 ? undefined : this.symbols[at]);
    switch (kind) {
      case "start":
        return before === START || (this.multiline && symbol(before).newline);
      case "end":
        return next === END || (this.multiline && symbol(next).newline);
      case "word":
        return ((symbol(before)?.word ?? false) !== (symbol(next)?.word ?? false)) !== negate;
      default: {
        const of = symbol(kind === "lookahead" ? next : before)?.of;
        const inside = of !== undefined && sets.some((set) => of[set]);
        if (whole) return inside !== negate;
        if (kind === "lookbehind") return !sure;
        return negate ? !inside || !sure : inside && !sure;
      }
    }
  }

  /** Nodes that a thread reaches without reading, `[node, ways]`. */
  reached(node, before, next, sure) {
    const ways = new Map();
    const visit = (at, on) => {
      ways.set(at, Math.min(2, (ways.get(at) ?? 0) + 1));
      for (const { to, assert } of this.free[at]) {
        if (on.has(to) || ways.get(to) === 2) continue;
        if (assert && !this.holds(assert, before, next, sure)) continue;
        on.add(to);
        visit(to, on);
        on.delete(to);
      }
    };
    visit(node, new Set([node]));
    return ways;
  }

  /** The thread behind one symbol: `[thread, ways]`. A thread is its node and the symbol in front of it. */
  step(thread, symbol) {
    const key = `${thread.id} ${symbol}`;
    let out = this.steps.get(key);
    if (out) return out;
    const of = this.symbols[symbol].of;
    const found = new Map();
    const add = (next, ways) => found.set(next, (found.get(next) ?? 0) + ways);
    if (thread.node === -1) add(this.thread(-1, symbol), 1);
    const from = thread.node === -1 ? this.begin : thread.node;
    for (const [at, ways] of this.reached(from, thread.before, symbol, false))
      for (const { to, set } of this.reads[at]) if (of[set]) add(this.thread(to, symbol), ways);
    out = [...found];
    this.steps.set(key, out);
    return out;
  }

  thread(node, before) {
    const group = before === START ? START : this.groups[before];
    const key = `${node} ${group}`;
    let thread = this.threads.get(key);
    if (!thread)
      this.threads.set(key, (thread = { id: this.threads.size, node, before: before === START ? START : group }));
    return thread;
  }

  /** Symbols in front are told apart only where an assertion looks back at them. */
  group() {
    const asserts = this.free.flat().flatMap(({ assert }) => (assert ? [assert] : []));
    const word = asserts.some(({ kind }) => kind === "word");
    const line = this.multiline && asserts.some(({ kind }) => kind === "start");
    const back = asserts.filter(({ kind }) => kind === "lookbehind").flatMap(({ sets }) => sets);
    const first = new Map();
    this.groups = this.symbols.map((symbol, at) => {
      const key = [word && symbol.word, line && symbol.newline, ...back.map((set) => symbol.of[set])].join(" ");
      if (!first.has(key)) first.set(key, at);
      return first.get(key);
    });
  }

  growth() {
    if (this.trouble !== null) return this.trouble;
    this.group();
    this.steps = new Map();
    this.threads = new Map();
    // Where a sticky pattern begins is decided by its scanner, not by a search.
    const all = this.sticky
      ? this.symbols.map((_, at) => this.thread(this.begin, at)).concat(this.thread(this.begin, START))
      : [this.thread(-1, START)];
    const next = new Map();
    for (let at = 0; at < all.length; at++) {
      const out = new Set();
      for (let symbol = 0; symbol < this.symbols.length; symbol++)
        for (const [thread] of this.step(all[at], symbol)) out.add(thread);
      next.set(all[at], out);
      for (const thread of out) if (!next.has(thread) && !all.includes(thread)) all.push(thread);
    }
    const from = new Map(all.map((thread) => [thread, reach(thread, next)]));
    const looping = all.filter((thread) => from.get(thread).has(thread));
    for (const p of looping) {
      const twice = this.twice(p, from);
      if (twice !== null && this.fails([p])) return twice;
      for (const q of looping) {
        if (p === q || q.node === -1 || !from.get(p).has(q)) continue;
        const text = this.crossing(p, q, from);
        if (text !== null && this.fails(p.node === -1 ? [q] : [p, q])) return text;
      }
    }
    return null;
  }

  /** A symbol that leads from a thread in two ways to one from which it comes back. */
  twice(p, from) {
    for (let symbol = 0; symbol < this.symbols.length; symbol++)
      for (const [to, ways] of this.step(p, symbol))
        if (ways > 1 && from.get(to).has(p)) return this.symbols[symbol].char;
    return null;
  }

  /** Text that reads p → p, p → q and q → q, or null. */
  crossing(p, q, from) {
    const back = (thread, goal) => thread === goal || from.get(thread).has(goal);
    const seen = new Set();
    const open = [[p, p, q, ""]];
    while (open.length > 0) {
      const [a, b, c, text] = open.shift();
      for (let symbol = 0; symbol < this.symbols.length; symbol++) {
        for (const [a2] of this.step(a, symbol)) {
          if (!back(a2, p)) continue;
          for (const [b2] of this.step(b, symbol)) {
            if (!back(b2, q)) continue;
            for (const [c2] of this.step(c, symbol)) {
              if (!back(c2, q)) continue;
              const read = text + this.symbols[symbol].char;
              if (a2 === p && b2 === q && c2 === q) return read;
              const key = `${a2.id} ${b2.id} ${c2.id}`;
              if (seen.has(key)) continue;
              seen.add(key);
              open.push([a2, b2, c2, read]);
            }
          }
        }
      }
    }
    return null;
  }

  /** Whether some text behind lets all of these threads fail. */
  fails(threads) {
    const accepts = (set, next) =>
      set.some((thread) => this.reached(thread.node, thread.before, next, true).has(this.accept));
    const seen = new Set();
    const open = [threads];
    while (open.length > 0) {
      const set = open.pop();
      if (!accepts(set, END)) return true;
      for (let symbol = 0; symbol < this.symbols.length; symbol++) {
        if (accepts(set, symbol)) continue;
        const next = [...new Set(set.flatMap((thread) => this.step(thread, symbol).map(([to]) => to)))];
        if (next.length === 0) return true;
        const key = next
          .map(({ id }) => id)
          .sort((x, y) => x - y)
          .join(" ");
        if (seen.has(key)) continue;
        seen.add(key);
        if (seen.size > MOST_SETS) return true;
        open.push(next);
      }
    }
    return false;
  }
}

function reach(thread, next) {
  const found = new Set();
  const open = [thread];
  while (open.length > 0)
    for (const to of next.get(open.pop()) ?? []) {
      if (found.has(to)) continue;
      found.add(to);
      open.push(to);
    }
  return found;
}

/** Whether this piece can read nothing. */
function nullable(element) {
  if (element.type === "Quantifier") return element.min === 0 || nullable(element.element);
  if (element.type === "Group" || element.type === "CapturingGroup")
    return element.alternatives.some((each) => each.elements.every(nullable));
  return element.type === "Assertion" || element.type === "Backreference";
}

/** Whether this piece has a repeat without bound. */
function endless(element) {
  if (element.type === "Quantifier") return element.max > WRITTEN_OUT || endless(element.element);
  return (element.alternatives ?? []).some?.((each) => each.elements?.some(endless)) ?? false;
}

/** Alternatives of exactly one character each, as they are written; null where one is longer. */
function singles(alternatives) {
  const all = alternatives.map(({ elements }) => (elements.length === 1 ? elements[0] : null));
  const single = (each) => ["Character", "CharacterSet", "CharacterClass"].includes(each?.type);
  return all.every(single) ? all.map(({ raw }) => raw) : null;
}

/** First characters of alternatives, where each begins with one; every character otherwise. */
function firsts(alternatives) {
  const all = alternatives.map(({ elements }) => singles([{ elements: elements.slice(0, 1) }])?.[0]);
  return all.every((raw) => raw !== undefined) ? all : [String.raw`[\s\S]`];
}
