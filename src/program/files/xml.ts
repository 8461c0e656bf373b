/** An element of an XML file. */
export interface XmlElement {
  /** As written, with its prefix. */
  readonly name: string;
  /** Without prefix. */
  readonly local: string;
  /** By their names as written. */
  readonly attributes: ReadonlyMap<string, string>;
  /** Elements and texts in their order. */
  readonly content: readonly (XmlElement | string)[];
  /** Line of its start, from 1. */
  readonly line: number;
}

/** What is wrong with a file; `line` from 1, 0 for the file as a whole. */
export interface XmlFault {
  readonly code: "notXml" | "tooLarge" | "tooMany" | "tooDeep" | "syntax" | "mismatch" | "cut";
  readonly line: number;
}

/** A read file: its outermost element, as far as it could be read, and what is wrong with it. */
export interface XmlFile {
  readonly root: XmlElement | null;
  readonly faults: readonly XmlFault[];
  /** Number of faults; only the first are listed. */
  readonly faultCount: number;
}

/** Limits of a file: characters, elements and texts, nested elements, attributes of an element, listed faults. */
export const XML_LIMITS = { length: 64e6, nodes: 2e6, depth: 200, attributes: 1000, faults: 20 };

const ENTITIES: Readonly<Record<string, string>> = { lt: "<", gt: ">", amp: "&", quot: '"', apos: "'" };
const NAME = /[^\s/>=<"'&!?]+/y;
const SPACE = /\s*/y;

/**
 * Characters of a text with its references resolved. Entities of the file itself are never expanded: they stay as
 * written, so that a file cannot grow.
 */
export function xmlText(raw: string): string {
  if (!raw.includes("&")) return raw;
  return raw.replace(/&(#x[0-9a-f]{1,6}|#\d{1,7}|[a-z]{2,4});/gi, (written, name: string) => {
    if (!name.startsWith("#")) return ENTITIES[name] ?? written;
    const code = /^#x/i.test(name) ? Number.parseInt(name.slice(2), 16) : Number(name.slice(1));
    // Halves of a pair of UTF-16 are no characters.
    return code > 0 && code <= 0x10ffff && code >> 11 !== 0x1b ? String.fromCodePoint(code) : written;
  });
}

interface Open {
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  readonly content: (XmlElement | string)[];
  readonly line: number;
}

const localName = (name: string) => name.slice(name.indexOf(":") + 1);
const closed = (o: Open): XmlElement => ({ ...o, local: localName(o.name) });

class Reader {
  readonly text: string;
  at = 0;
  private line = 1;
  /** Where that line ends. */
  private lineEnd: number;

  constructor(text: string) {
    this.text = text;
    this.lineEnd = this.endBehind(0);
  }

  private endBehind(place: number): number {
    const end = this.text.indexOf("\n", place);
    return end < 0 ? Infinity : end;
  }

  /** Line of a place; places are asked for in their order. */
  lineOf(place: number): number {
    for (; this.lineEnd < place; this.lineEnd = this.endBehind(this.lineEnd + 1)) this.line += 1;
    return this.line;
  }

  /** What stands up to an end, which is passed; null where the end is missing. */
  upTo(end: string, from: number): string | null {
    const to = this.text.indexOf(end, from);
    if (to < 0) return null;
    this.at = to + end.length;
    return this.text.slice(from, to);
  }

  private matched(form: RegExp): string {
    form.lastIndex = this.at;
    const found = form.exec(this.text)?.[0] ?? "";
    this.at += found.length;
    return found;
  }

  name(): string {
    return this.matched(NAME);
  }

  space() {
    this.matched(SPACE);
  }

  /** Passes a document type with its inner declarations; none of them is used. */
  documentType(): boolean {
    let depth = 0;
    for (; this.at < this.text.length; this.at += 1) {
      const c = this.text[this.at];
      if (c === '"' || c === "'") {
        const end = this.text.indexOf(c, this.at + 1);
        if (end < 0) return false;
        this.at = end;
      } else if (this.text.startsWith("<!--", this.at)) {
        const end = this.text.indexOf("-->", this.at + 4);
        if (end < 0) return false;
        this.at = end + 2;
      } else if (c === "[") depth += 1;
      else if (c === "]") depth -= 1;
      else if (c === ">" && depth <= 0) {
        this.at += 1;
        return true;
      }
    }
    return false;
  }

  /** Attributes up to the end of a tag; null where they are none. */
  attributes(): { readonly all: Map<string, string>; readonly isEmpty: boolean } | null {
    const all = new Map<string, string>();
    for (;;) {
      this.space();
      const c = this.text[this.at];
      if (c === ">") {
        this.at += 1;
        return { all, isEmpty: false };
      }
      if (c === "/" && this.text[this.at + 1] === ">") {
        this.at += 2;
        return { all, isEmpty: true };
      }
      const name = this.name();
      this.space();
      if (name === "" || this.text[this.at] !== "=" || all.size >= XML_LIMITS.attributes) return null;
      this.at += 1;
      this.space();
      const quote = this.text[this.at],
        value = quote === '"' || quote === "'" ? this.upTo(quote, this.at + 1) : null;
      if (value === null || value.includes("<")) return null;
      if (!all.has(name)) all.set(name, xmlText(value));
    }
  }
}

/** Whether a text begins as XML does, with its declaration, a comment, a document type or an element. */
export const isXml = (text: string) => /^\uFEFF?\s*<(?:\?xml|!--|!DOCTYPE|[A-Za-z_])/.test(text.slice(0, 1000));

/**
 * Reads a file as far as it goes. Never throws; within XML_LIMITS; loads nothing and expands no entity. `spaces`: whether
 * texts of nothing but white space are kept; they are for files whose elements are running text.
 */
export function readXml(text: string, spaces: "dropped" | "kept" = "dropped"): XmlFile {
  const reader = new Reader(text),
    faults: XmlFault[] = [],
    open: Open[] = [];
  let faultCount = 0,
    nodes = 0,
    root: XmlElement | null = null;
  const fault = (code: XmlFault["code"], at: number | null) => {
    faultCount += 1;
    if (faults.length < XML_LIMITS.faults) faults.push({ code, line: at === null ? 0 : reader.lineOf(at) });
  };
  const put = (node: XmlElement | string) => {
    const parent = open.at(-1);
    nodes += 1;
    if (parent) parent.content.push(node);
    else if (typeof node !== "string") root ??= node;
  };
  /** Closes the innermost element. */
  const close = () => {
    const last = open.pop();
    if (last) put(closed(last));
  };
  const endTag = (start: number) => {
    reader.at = start + 2;
    const name = reader.name();
    if (reader.upTo(">", reader.at) === null) return false;
    if (!open.some((o) => o.name === name)) fault("mismatch", start);
    else {
      if (open.at(-1)?.name !== name) fault("mismatch", start);
      while (open.at(-1)?.name !== name) close();
      close();
    }
    return true;
  };
  const startTag = (start: number) => {
    reader.at = start + 1;
    const name = reader.name(),
      line = reader.lineOf(start),
      found = name === "" ? null : reader.attributes();
    if (!found) {
      fault("syntax", start);
      // Reading goes on behind the tag, where there is one.
      return reader.upTo(">", start + 1) !== null;
    }
    const made: Open = { name, attributes: found.all, content: [], line };
    if (found.isEmpty) put(closed(made));
    else open.push(made);
    return true;
  };
  /** Comment, instruction, document type, CDATA or tag at a `<`; false where its end is missing. */
  const markup = (start: number): boolean => {
    if (text.startsWith("<!--", start)) return reader.upTo("-->", start + 4) !== null;
    if (text.startsWith("<?", start)) return reader.upTo("?>", start + 2) !== null;
    if (text.startsWith("<![CDATA[", start)) {
      const inside = reader.upTo("]]>", start + 9);
      if (inside) put(inside);
      return inside !== null;
    }
    if (text.startsWith("<!", start)) {
      reader.at = start + 2;
      return reader.documentType();
    }
    return text[start + 1] === "/" ? endTag(start) : startTag(start);
  };

  if (!isXml(text)) fault("notXml", null);
  else if (text.length > XML_LIMITS.length) fault("tooLarge", null);
  if (faultCount > 0) return { root, faults, faultCount };
  for (;;) {
    const start = text.indexOf("<", reader.at);
    if (start < 0 || (root && open.length === 0)) break;
    const before = text.slice(reader.at, start);
    if (open.length > 0 && (spaces === "kept" ? before !== "" : before.trim() !== "")) put(xmlText(before));
    if (!markup(start)) {
      fault("cut", start);
      break;
    }
    if (open.length > XML_LIMITS.depth || nodes > XML_LIMITS.nodes) {
      fault(nodes > XML_LIMITS.nodes ? "tooMany" : "tooDeep", start);
      break;
    }
  }
  if (open.length > 0 && faultCount === 0) fault("cut", null);
  while (open.length > 0) close();
  return { root, faults, faultCount };
}

/** Elements directly inside one, those of a local name if one is given. */
export const elementsIn = (e: XmlElement, local?: string): readonly XmlElement[] =>
  e.content.filter((c): c is XmlElement => typeof c !== "string" && (local === undefined || c.local === local));

/** Elements of one of the local names, in their order; those inside one that is found are not looked at. */
export const elementsOf = (e: XmlElement, ...locals: readonly string[]): readonly XmlElement[] =>
  elementsIn(e).flatMap((inner) => (locals.includes(inner.local) ? [inner] : elementsOf(inner, ...locals)));

/** Text of an element and of all inside it. */
export const textInside = (e: XmlElement): string =>
  e.content.map((c) => (typeof c === "string" ? c : textInside(c))).join("");

/** Value of an attribute by its local name, whatever its prefix. */
export function attributeOf(e: XmlElement, local: string): string | undefined {
  const plain = e.attributes.get(local);
  if (plain !== undefined) return plain;
  for (const [name, value] of e.attributes) if (localName(name) === local) return value;
  return undefined;
}
