import { inScreenWriting } from "../../i18n/number.ts";
import type { GuideBlocksTexts } from "../../i18n/en/guide-blocks.ts";
import type { Texts } from "../../i18n/index.ts";
import type { Statement } from "../../nc/statement.ts";
import { fieldsOf, statementLine } from "../../app/fields/blocks/block-fields.ts";
import { letterOf, wordOfField } from "../../app/fields/blocks/block-guide.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import type { WordField } from "../../app/fields/blocks/field.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useEditor } from "../../app/document/store.ts";
import { blockSources } from "./block-source.ts";
import { whyUnseen } from "./block-samples.ts";
import { blockRule, blockWordTexts } from "./block-words.ts";
import { GuideButton } from "./GuideButton.tsx";
import { showGuide } from "../../app/place/place.ts";
import { useGuidedBlock } from "../../app/place/open-call.ts";
import { GlossaryText, GlossaryList, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";
import { applyToBlock } from "./apply-value.ts";
import { useTriedBlock } from "./use-tried-block.ts";
import { ValueCard } from "./ValueCard.tsx";

/** Kinds of blocks that have a page. */
type PagedKind = BlockKind & keyof GuideBlocksTexts["kinds"];

/** Name of the page of a block, or of one of its words. */
export const blockPage = (kind: BlockKind, word: string | null): readonly string[] => [
  "guide",
  "block",
  word === null ? kind : `${kind}.${word}`,
];

/** Re-renders when the block shown may have changed. */
function useSources(): void {
  useGuidedBlock();
  useEditor((s) => s.program);
}

/** The name of a field, without the letter in front of it on its page. */
function wordName(
  { editor: t }: Pick<Texts, "editor">,
  { name, ...field }: Pick<WordField, "name" | "id" | "letter">,
): string {
  const letter = letterOf(field);
  const full = typeof name === "string" ? t.fields[name] : t.fields.wordOf(name.word);
  return full.endsWith(` ${letter}`) ? full.slice(0, -letter.length - 1) : full === letter ? "" : full;
}

interface Props {
  readonly kind: BlockKind;
  readonly field: WordField;
}

/** A word at several values, simulated in the open program or in a sample. */
function WordPictures({ kind, field }: Props) {
  const t = useTexts("guide");
  const blocks = useTexts("guide-blocks");
  const { editor } = useTexts();
  const language = useSettings((s) => s.language);
  const word = wordOfField(field);
  const { made, working } = useTriedBlock(kind, word);
  const hasOwn = blockSources(kind, word).some(({ line }) => line !== null);
  const choices: Readonly<Record<string, string>> = editor.choices;
  const sizes = field.choices || made?.tried.length !== 3 ? [] : [t.values.small, t.values.usual, t.values.large];
  const letter = letterOf(field);
  return (
    <section className="guide-values" aria-label={t.values.title} aria-busy={working}>
      <h2>{t.values.title}</h2>
      {made && <p className="soft">{made.line === null ? blocks.sampleLead : blocks.ownLead}</p>}
      {made === undefined && (
        <p className="guide-working soft" role="status">
          {t.values.working}
        </p>
      )}
      {made === null && <p className="soft">{blocks.why[whyUnseen(kind, field)]}</p>}
      {made?.line === null && hasOwn && <p className="soft">{blocks.why.yours}</p>}
      {made && (
        <ol className="value-cards">
          {made.tried.map((tried, i) => {
            const { line } = made;
            const said = field.choices ? (choices[tried.text] ?? tried.text) : inScreenWriting(language, tried.text);
            const text = said === "" ? editor.none : said;
            return (
              <ValueCard
                key={tried.text}
                tried={tried}
                box={made.box}
                letter={letter === "" ? wordName({ editor }, field) : letter}
                text={text}
                unit={field.unit ?? ""}
                size={sizes[i] ?? null}
                whole
                whose={tried.isUsual ? (line === null ? t.values.printed : t.values.yours) : null}
                take={
                  line === null || tried.isUsual ? null : () => void applyToBlock(line, kind, word, tried.text, letter)
                }
              />
            );
          })}
        </ol>
      )}
    </section>
  );
}

/** The control's rule for a block or a word. */
function Rules({ sentences }: { readonly sentences: readonly string[] }) {
  const blocks = useTexts("guide-blocks");
  return (
    <section aria-label={blocks.rule}>
      <h2>{blocks.rule}</h2>
      {sentences
        .filter((sentence) => sentence !== "")
        .map((sentence) => (
          <p key={sentence}>
            <GlossaryText text={sentence} />
          </p>
        ))}
      <p className="soft small">{blocks.recalled}</p>
    </section>
  );
}

function Mistakes({ sentences }: { readonly sentences: readonly string[] }) {
  const t = useTexts("guide");
  return (
    <section className="guide-mistakes" aria-label={t.mistakes}>
      <h2>{t.mistakes}</h2>
      <GlossaryList texts={sentences} />
    </section>
  );
}

/** The known M functions. */
function Functions() {
  const blocks = useTexts("guide-blocks");
  return (
    <section aria-label={blocks.functions}>
      <h2>{blocks.functions}</h2>
      <dl className="guide-points">
        {Object.entries(blocks.m).map(([name, about]) => (
          <div key={name}>
            <dt>
              <b className="number">{name}</b>
            </dt>
            <dd>{about}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}

/** The page of a kind of block: its purpose, and the links to its words. */
function OfBlock({ kind }: { readonly kind: PagedKind }) {
  const blocks = useTexts("guide-blocks");
  const { kinds: names } = useTexts().editor;
  useSources();
  const [source] = blockSources(kind, null);
  const { about, rule, mistakes } = blocks.kinds[kind];
  return (
    <GlossaryScope texts={[about, rule, ...mistakes]}>
      <header className="guide-head">
        <p className="soft">{blocks.title}</p>
        <h1>{names[kind]}</h1>
        <p>
          <GlossaryText text={about} />
        </p>
        {source && (
          <p className="soft">
            {blocks.inProgram}: <code className="number">{statementLine(source.statement)}</code>
          </p>
        )}
      </header>
      {source && <Words kind={kind} source={source.statement} but={null} />}
      {kind === "functions" && <Functions />}
      <Rules sentences={[rule]} />
      <Mistakes sentences={mistakes} />
    </GlossaryScope>
  );
}

/** The links to the words of a block. */
function Words({
  kind,
  source,
  but,
}: {
  readonly kind: BlockKind;
  readonly source: Statement;
  readonly but: string | null;
}) {
  const texts = useTexts();
  const blocks = useTexts("guide-blocks");
  const fields = fieldsOf(source).filter((field) => wordOfField(field) !== but && blockWordTexts(blocks, kind, field));
  if (fields.length === 0) return null;
  return (
    <section aria-label={blocks.words}>
      <h2>{blocks.words}</h2>
      <ul className="guide-links">
        {fields.map((field) => (
          <GuideButton key={field.id} to={blockPage(kind, wordOfField(field))}>
            <b className="number">{letterOf(field)}</b> {wordName(texts, field)}
          </GuideButton>
        ))}
      </ul>
    </section>
  );
}

/** The page of a word of a block. */
function OfWord({ kind, word }: { readonly kind: PagedKind; readonly word: string }) {
  const t = useTexts("guide");
  const blocks = useTexts("guide-blocks");
  const places = useTexts("guide-places");
  const texts = useTexts();
  useSources();
  const [source] = blockSources(kind, word);
  const all = source ? fieldsOf(source.statement) : [];
  const at = all.findIndex((each) => wordOfField(each) === word),
    field = all[at];
  const said = field && blockWordTexts(blocks, kind, field, places);
  if (!source || !field || !said) return <h1>{t.missing}</h1>;
  const rules = [blockRule(blocks, kind, word), blocks.kinds[kind].rule];
  const turn = (to: WordField | undefined, icon: "up" | "down", name: string, long: (name: string) => string) => (
    <button
      type="button"
      className="button"
      disabled={!to}
      aria-label={to && long([letterOf(to), wordName(texts, to)].join(" ").trim())}
      onClick={() => to && showGuide(...blockPage(kind, wordOfField(to)))}
    >
      <Icon name={icon} /> {name}
    </button>
  );
  return (
    <GlossaryScope texts={[said.about, ...said.mistakes, ...rules]}>
      <header className="guide-head">
        <p className="soft">{texts.editor.kinds[kind]}</p>
        <h1>
          <span className="number prompt-q">{letterOf(field)}</span> {wordName(texts, field)}
        </h1>
        <p>
          <GlossaryText text={said.about} />
        </p>
        <p className="soft">
          {blocks.inProgram}: <code className="number">{statementLine(source.statement)}</code>
        </p>
        <div className="guide-turns">
          {turn(all[at - 1], "up", t.previous, t.previousLong)} {turn(all[at + 1], "down", t.next, t.nextLong)}
        </div>
      </header>
      <WordPictures kind={kind} field={field} />
      {word === "functions" && <Functions />}
      <div className="guide-columns">
        <Mistakes sentences={said.mistakes} />
        <Rules sentences={rules} />
      </div>
      <Words kind={kind} source={source.statement} but={word} />
    </GlossaryScope>
  );
}

/** A page of a block, by its name in the address: its kind, and after a point the word. */
export function BlockPage({ name }: { readonly name: string }) {
  const t = useTexts("guide");
  const { kinds } = useTexts("guide-blocks");
  const [kind = "", ...rest] = name.split("."),
    word = rest.join(".");
  if (!Object.hasOwn(kinds, kind)) return <h1>{t.missing}</h1>;
  const known = kind as PagedKind;
  return word === "" ? <OfBlock key={name} kind={known} /> : <OfWord key={name} kind={known} word={word} />;
}

/** The links to the pages of all blocks. */
export function BlockLinks() {
  const { kinds } = useTexts("guide-blocks");
  const { kinds: names } = useTexts().editor;
  return (Object.keys(kinds) as readonly PagedKind[]).map((kind) => (
    <GuideButton key={kind} to={blockPage(kind, null)}>
      {names[kind]}
    </GuideButton>
  ));
}
