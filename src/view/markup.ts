/** What XML allows in no form: control characters but tab and line ends, halves of a pair, and two code points. */
const NOT_IN_XML = /[^\t\n\r\u0020-\uD7FF\uE000-\uFFFD\u{10000}-\u{10FFFF}]/gu;
const MARKS: Readonly<Record<string, string>> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };

/** Text as it stands in XML and HTML, between tags and in attributes: a name never becomes markup. */
export const escapedText = (text: string): string =>
  text.replace(NOT_IN_XML, "\uFFFD").replace(/[&<>"']/g, (mark) => MARKS[mark] ?? mark);
