import { part21Text } from "./part21-text.ts";

/** Value of a parameter: `$` is null, `*` (derived) undefined, a list an array. */
export type Part21Value =
  | number
  | string
  | null
  | undefined
  | Part21Reference
  | Part21Enumeration
  | Part21Binary
  | Part21Record
  | readonly Part21Value[];

/** `#12`: another entity. */
export interface Part21Reference {
  readonly kind: "reference";
  readonly id: number;
}

/** `.MILLI.`; a boolean is T or F. */
export interface Part21Enumeration {
  readonly kind: "enumeration";
  readonly name: string;
}

/** `"0FA"`: the first digit counts the unused bits. */
export interface Part21Binary {
  readonly kind: "binary";
  readonly digits: string;
}

/** A keyword with its parameters: a line of the header, a part of an entity, or a typed parameter. */
export interface Part21Record {
  readonly kind: "record";
  /** In capital letters. */
  readonly type: string;
  readonly values: readonly Part21Value[];
}

/** One entity: a single record, or several of a complex (externally mapped) instance. */
export type Part21Entity = readonly Part21Record[];

/** What is wrong with a file; `line` from 1, 0 for the file as a whole. */
export interface Part21Fault {
  readonly code: "notPart21" | "tooLarge" | "tooMany" | "syntax" | "tooDeep" | "twice" | "cut";
  readonly line: number;
}

/** A read file; entities in their order. What could not be read is left out and named by a fault. */
export interface Part21File {
  readonly header: readonly Part21Record[];
  /** Schemas named in the header, in capital letters: AUTOMOTIVE_DESIGN. */
  readonly schemas: readonly string[];
  readonly entities: ReadonlyMap<number, Part21Entity>;
  readonly faults: readonly Part21Fault[];
  /** Number of faults; only the first are listed. */
  readonly faultCount: number;
}

/** Limits of a file: characters, entities, values, depth of lists, listed faults. */
export const PART21_LIMITS = { length: 64e6, entities: 2e6, values: 4e7, depth: 40, faults: 20 };

const [HASH, QUOTE, DOUBLE, OPEN, CLOSE, STAR, PLUS, COMMA, MINUS, DOT, SLASH] = [
  35, 39, 34, 40, 41, 42, 43, 44, 45, 46, 47,
];
const [ZERO, NINE, SEMICOLON, EQUAL, DOLLAR, BANG, UNDERSCORE, SPACE] = [48, 57, 59, 61, 36, 33, 95, 32];
const isDigit = (c: number) => c >= ZERO && c <= NINE;
const isLetter = (c: number) => (c >= 65 && c <= 90) || (c >= 97 && c <= 122) || c === UNDERSCORE;
const isOfNumber = (c: number) => isDigit(c) || c === DOT || c === MINUS || c === PLUS || c === 69 || c === 101;

/** Thrown and caught within this file only: reading goes on behind the next semicolon. */
class Unreadable {
  readonly code: "syntax" | "tooDeep" | "tooMany";
  constructor(code: "syntax" | "tooDeep" | "tooMany") {
    this.code = code;
  }
}

class Reader {
  readonly text: string;
  at = 0;
  private left = PART21_LIMITS.values;
  /** Keywords and enumerations repeat: one string and one object for each. */
  private readonly names = new Map<string, string>();
  private readonly enumerations = new Map<string, Part21Enumeration>();

  constructor(text: string) {
    this.text = text;
  }

  /** The next character that is neither space nor comment, without reading it; NaN at the end. */
  peek(): number {
    for (;;) {
      const c = this.text.charCodeAt(this.at);
      if (c <= SPACE || c === 0xfeff) this.at += 1;
      else if (c === SLASH && this.text.charCodeAt(this.at + 1) === STAR) {
        const end = this.text.indexOf("*/", this.at + 2);
        this.at = end < 0 ? this.text.length : end + 2;
      } else return c;
    }
  }

  /** Reads this character if it is next. */
  take(c: number): boolean {
    if (this.peek() !== c) return false;
    this.at += 1;
    return true;
  }

  need(c: number) {
    if (!this.take(c)) throw new Unreadable("syntax");
  }

  /** A keyword in capital letters; "" when none is next. */
  keyword(): string {
    const first = this.peek(),
      start = this.at;
    if (!isLetter(first) && first !== BANG) return "";
    let end = start + 1;
    for (let c = this.text.charCodeAt(end); isLetter(c) || isDigit(c) || c === MINUS; c = this.text.charCodeAt(end))
      end += 1;
    this.at = end;
    const written = this.text.slice(start, end),
      known = this.names.get(written);
    if (known !== undefined) return known;
    const name = written.toUpperCase();
    this.names.set(written, name);
    return name;
  }

  /** The digits behind `#`. */
  id(): number {
    this.need(HASH);
    let id = 0;
    const start = this.at;
    for (let c = this.text.charCodeAt(this.at); isDigit(c); c = this.text.charCodeAt(this.at)) {
      id = id * 10 + c - ZERO;
      this.at += 1;
    }
    if (this.at === start || !Number.isSafeInteger(id)) throw new Unreadable("syntax");
    return id;
  }

  private number(): number {
    const start = this.at;
    while (isOfNumber(this.text.charCodeAt(this.at))) this.at += 1;
    const n = Number(this.text.slice(start, this.at));
    if (!Number.isFinite(n)) throw new Unreadable("syntax");
    return n;
  }

  private string(): string {
    const start = this.at + 1;
    for (let from = start; ;) {
      const end = this.text.indexOf("'", from);
      if (end < 0) throw new Unreadable("syntax");
      if (this.text.charCodeAt(end + 1) !== QUOTE) {
        this.at = end + 1;
        return part21Text(this.text.slice(start, end));
      }
      from = end + 2;
    }
  }

  private enclosed(end: "." | '"', form: RegExp): string {
    const from = this.at + 1,
      to = this.text.indexOf(end, from),
      inside = to < 0 || to - from > 1e5 ? "" : this.text.slice(from, to);
    if (!form.test(inside)) throw new Unreadable("syntax");
    this.at = to + 1;
    return inside;
  }

  private enumeration(): Part21Enumeration {
    const written = this.enclosed(".", /^[A-Za-z_][A-Za-z0-9_]*$/),
      known = this.enumerations.get(written);
    if (known) return known;
    const made: Part21Enumeration = { kind: "enumeration", name: written.toUpperCase() };
    this.enumerations.set(written, made);
    return made;
  }

  private value(depth: number): Part21Value {
    this.left -= 1;
    if (this.left < 0) throw new Unreadable("tooMany");
    const c = this.peek();
    if (isDigit(c) || c === MINUS || c === PLUS) return this.number();
    if (c === DOT) return isDigit(this.text.charCodeAt(this.at + 1)) ? this.number() : this.enumeration();
    if (c === OPEN) return this.list(depth + 1);
    if (c === HASH) return { kind: "reference", id: this.id() };
    if (c === QUOTE) return this.string();
    if (c === DOUBLE) return { kind: "binary", digits: this.enclosed('"', /^[0-9A-Fa-f]+$/) };
    if (this.take(DOLLAR)) return null;
    if (this.take(STAR)) return undefined;
    return this.record(depth + 1);
  }

  private list(depth: number): Part21Value[] {
    if (depth > PART21_LIMITS.depth) throw new Unreadable("tooDeep");
    this.need(OPEN);
    const values: Part21Value[] = [];
    if (this.take(CLOSE)) return values;
    do values.push(this.value(depth));
    while (this.take(COMMA));
    this.need(CLOSE);
    return values;
  }

  record(depth: number): Part21Record {
    const type = this.keyword();
    if (type === "") throw new Unreadable("syntax");
    return { kind: "record", type, values: this.list(depth) };
  }

  /** What follows the equal sign of an entity. */
  entity(): Part21Entity {
    if (!this.take(OPEN)) return [this.record(0)];
    const records: Part21Record[] = [];
    while (!this.take(CLOSE)) records.push(this.record(0));
    return records;
  }

  /** Goes behind the next semicolon outside of strings and comments. */
  skip() {
    for (let c = this.peek(); !Number.isNaN(c); c = this.peek()) {
      this.at += 1;
      if (c === SEMICOLON) return;
      if (c !== QUOTE) continue;
      const end = this.text.indexOf("'", this.at);
      // A string that never ends would take the rest of the file with it.
      if (end >= 0) this.at = end + 1;
    }
  }

  line(at: number): number {
    let line = 1;
    for (let i = this.text.indexOf("\n"); i >= 0 && i < at; i = this.text.indexOf("\n", i + 1)) line += 1;
    return line;
  }
}

/** Whether a text begins as a Part 21 file does. */
export const isPart21 = (text: string) =>
  /^\uFEFF?(?:\s|\/\*(?:[^*]|\*(?!\/))*\*\/)*ISO-10303-21\s*;/.test(text.slice(0, 4096));

const schemasOf = (header: readonly Part21Record[]): string[] => {
  const list = header.find((r) => r.type === "FILE_SCHEMA")?.values[0];
  return Array.isArray(list)
    ? (list as readonly Part21Value[]).flatMap((s) => (typeof s === "string" ? [s.trim().toUpperCase()] : []))
    : [];
};

/**
 * Reads an exchange file in clear text (ISO 10303-21, STEP): header, all data sections, simple and complex entities. The
 * sections of edition 3 (ANCHOR, REFERENCE, SIGNATURE) are passed over. Never throws; within PART21_LIMITS.
 */
export function readPart21(text: string): Part21File {
  const header: Part21Record[] = [],
    entities = new Map<number, Part21Entity>(),
    faults: Part21Fault[] = [];
  let faultCount = 0,
    section = "",
    ended = false;
  const reader = new Reader(text);
  const fault = (code: Part21Fault["code"], at: number | null) => {
    faultCount += 1;
    if (faults.length < PART21_LIMITS.faults) faults.push({ code, line: at === null ? 0 : reader.line(at) });
  };
  const result = () => ({ header, schemas: schemasOf(header), entities, faults, faultCount });
  if (!isPart21(text)) fault("notPart21", null);
  else if (text.length > PART21_LIMITS.length) fault("tooLarge", null);
  if (faultCount > 0) return result();

  const statement = () => {
    if (reader.peek() === HASH) {
      if (section !== "DATA") return reader.skip();
      const start = reader.at,
        id = reader.id();
      reader.need(EQUAL);
      const entity = reader.entity();
      reader.need(SEMICOLON);
      if (entities.size >= PART21_LIMITS.entities) throw new Unreadable("tooMany");
      if (entities.has(id)) fault("twice", start);
      else entities.set(id, entity);
      return;
    }
    const start = reader.at,
      word = reader.keyword();
    if (word === "ENDSEC") section = "";
    else if (word === "END-ISO-10303-21") ended = true;
    else if (section === "HEADER") {
      reader.at = start;
      header.push(reader.record(0));
      reader.need(SEMICOLON);
      return;
    } else if (section === "" && word !== "") section = word;
    else if (section === "DATA") throw new Unreadable("syntax");
    reader.skip();
  };
  reader.keyword();
  reader.skip();
  while (!ended && !Number.isNaN(reader.peek())) {
    const start = reader.at;
    try {
      statement();
    } catch (e) {
      if (!(e instanceof Unreadable)) throw e;
      fault(e.code, start);
      if (e.code === "tooMany") return result();
      reader.at = start;
      reader.skip();
    }
  }
  if (!ended) fault("cut", null);
  return result();
}
