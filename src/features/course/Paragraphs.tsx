import { GlossaryText, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";
import { Unbroken } from "../../app/base/Unbroken.tsx";

const unbroken = (text: string) => <Unbroken text={text} />;

interface Props {
  readonly text: string;
  /** Texts of the previous pages: a glossary term links where it is used first. Absent: no links. */
  readonly before?: readonly string[];
}

/** A text of the course, with paragraphs at empty lines. */
export function Paragraphs({ text, before }: Props) {
  const paragraphs = text.split(/\n[^\S\n]*\n/).filter((each, i) => i === 0 || each.trim() !== "");
  const said = (plain: boolean) =>
    paragraphs.map((each, i) => (
      <p key={i}>{plain ? unbroken(each) : <GlossaryText text={each} plain={unbroken} />}</p>
    ));
  return before ? (
    <GlossaryScope texts={paragraphs} before={before}>
      {said(false)}
    </GlossaryScope>
  ) : (
    said(true)
  );
}
