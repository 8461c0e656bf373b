import { attributeOf, elementsIn, isXml, readXml, textInside, type XmlElement } from "../files/xml.ts";
import { camTool } from "./cam-tool.ts";
import { unitOf, type FileProperty } from "./facts.ts";
import { MOST_ITEMS, type ForeignContent, type ReadingContext } from "./foreign-file.ts";
import { sorted } from "./fusion.ts";
import { toolOfProperties } from "./property-lists.ts";

/*
 * XML: libraries of HSMWorks and Inventor CAM (.hsmlib), and the property data of makers, by the letters of DIN 4000 or
 * the symbols of ISO 13399 (Tool-Data of DIN 4000-102). Sources: docs/decisions, tool files of other systems.
 */

const child = (element: XmlElement, name: string): XmlElement | undefined => elementsIn(element, name)[0];
const said = (element: XmlElement | undefined): string => (element ? textInside(element).trim().slice(0, 200) : "");

/** Parts of a tool whose attributes are its properties. */
const PARTS = ["nc", "body", "insert", "turning-holder", "turning-setup"];
/** A shop's file writes the parts of a turning tool with or without the hyphen. */
const PART_NAMES: Readonly<Record<string, string>> = { turningholder: "turning-holder", turningsetup: "turning-setup" };

function hsmTools(root: XmlElement, unit: ReadingContext["unit"]): ForeignContent {
  const tools = elementsIn(root, "tool").slice(0, MOST_ITEMS);
  const unitOfTool = (tool: XmlElement) => unitOf(attributeOf(tool, "unit") ?? "");
  return {
    ...sorted(
      tools.map((tool) => {
        const properties = new Map<string, FileProperty>();
        for (const part of elementsIn(tool)) {
          const name = PART_NAMES[part.local] ?? part.local;
          if (PARTS.includes(name))
            for (const [attribute, value] of part.attributes) properties.set(`${name}.${attribute}`, { value });
        }
        return camTool(properties, unitOfTool(tool) ?? unit, {
          type: attributeOf(tool, "type") ?? "",
          description: said(child(tool, "description")),
          product: said(child(tool, "product-id")),
        });
      }),
    ),
    unitAsked: tools.some((tool) => unitOfTool(tool) === null),
  };
}

/** Elements of a name anywhere inside. */
function within(element: XmlElement, name: string, depth = 0): readonly XmlElement[] {
  if (element.local.toLowerCase() === name) return [element];
  return depth > 8 ? [] : elementsIn(element).flatMap((each) => within(each, name, depth + 1));
}

/** A property: its name, its value and the unit that some files state. */
function propertyOf(element: XmlElement): readonly [string, FileProperty] | null {
  const part = (name: string) => elementsIn(element).find((each) => each.local.toLowerCase() === name);
  const name = said(part("propertyname")).toUpperCase();
  const value = said(part("value"));
  const unit = unitOf(said(part("unit")));
  return name === "" || value === "" ? null : [name, { value, ...(unit && { unit }) }];
}

function propertyTools(root: XmlElement, unit: ReadingContext["unit"]): ForeignContent | null {
  const read = within(root, "tool")
    .slice(0, MOST_ITEMS)
    .flatMap((tool) => {
      const data = [...within(tool, "category-data"), ...within(tool, "property-data")];
      const properties = new Map(data.map(propertyOf).filter((each) => each !== null));
      const [id] = ["primaryid", "id21002"]
        .flatMap((name) => within(tool, name).map(said))
        .filter((each) => each !== "");
      return properties.size === 0 ? [] : [toolOfProperties(properties, unit, id ?? "")];
    });
  if (read.length === 0) return null;
  return { ...sorted(read.map(({ item }) => item)), unitAsked: read.some((each) => each.unitAsked) };
}

/** What is read from the outermost element of an XML file; null when the text is none. */
function fromXml(text: string, read: (root: XmlElement) => ForeignContent | null): ForeignContent | null {
  if (!isXml(text)) return null;
  const { root, faults } = readXml(text);
  const content = root && read(root);
  return content && { ...content, cutShort: faults.some(({ code }) => code === "cut") };
}

/** Reads a tool library of HSMWorks or Inventor CAM; null when the text is none. */
export const readHsmLibrary = (text: string, { unit }: ReadingContext): ForeignContent | null =>
  text.includes("<tool-library")
    ? fromXml(text, (root) => (root.local === "tool-library" ? hsmTools(root, unit) : null))
    : null;

/** Reads property data of tools (DIN 4000, ISO 13399) in XML; null when the text is none. */
export const readPropertyXml = (text: string, { unit }: ReadingContext): ForeignContent | null =>
  fromXml(text, (root) => propertyTools(root, unit));
