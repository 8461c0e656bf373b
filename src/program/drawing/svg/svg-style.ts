import { attributeOf, elementsIn, textInside, type XmlElement } from "../../files/xml.ts";

/** Declarations of a style: properties by name. */
export type SvgStyle = ReadonlyMap<string, string>;

/** Rules of the style sheets of a file, by their simple selector: `.class`, `#id`, `element`. */
export type SvgRules = ReadonlyMap<string, SvgStyle>;

const declarations = (text: string): SvgStyle =>
  new Map(
    text.split(";").flatMap((d) => {
      const i = d.indexOf(":");
      return i > 0
        ? [
            [
              d.slice(0, i).trim(),
              d
                .slice(i + 1)
                .replace("!important", "")
                .trim(),
            ] as const,
          ]
        : [];
    }),
  );

/** A comment that is never closed reaches to the end. */
const withoutComments = (text: string): string =>
  text
    .split("/*")
    .map((part, i) => (i === 0 ? part : (part.split("*/", 2)[1] ?? "")))
    .join("");

/** Rules of all style elements; selectors of more than one part are none of ours. */
export function rulesOf(root: XmlElement): SvgRules {
  const rules = new Map<string, SvgStyle>();
  const visit = (e: XmlElement) => {
    if (e.local !== "style") return elementsIn(e).forEach(visit);
    const text = withoutComments(textInside(e));
    for (const [, selectors = "", body = ""] of text.matchAll(/(?<![^{}])([^{}]+)\{([^{}]*)\}/g))
      for (const selector of selectors.split(",").map((s) => s.trim()))
        if (/^[.#]?[\w-]+$/.test(selector))
          rules.set(selector, new Map([...(rules.get(selector) ?? []), ...declarations(body)]));
  };
  visit(root);
  return rules;
}

/** Value of a property: of the style attribute, then of the rules, then of the attribute of that name. */
export function propertyOf(e: XmlElement, rules: SvgRules, property: string): string | undefined {
  const own = declarations(attributeOf(e, "style") ?? "").get(property);
  if (own !== undefined) return own;
  const classes = (attributeOf(e, "class") ?? "").split(/\s+/).filter((c) => c !== "");
  for (const selector of [`#${attributeOf(e, "id") ?? ""}`, ...classes.map((c) => `.${c}`), e.local]) {
    const found = rules.get(selector)?.get(property);
    if (found !== undefined) return found;
  }
  return e.attributes.get(property);
}
