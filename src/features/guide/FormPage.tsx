import { useId, useMemo } from "react";
import { pointText } from "../../view/approach/points.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { PointName } from "../../kernel/plane/approach.ts";
import { compensate } from "../../kernel/plane/compensate.ts";
import { plane } from "../../kernel/plane/plane.ts";
import { APPROACH_FORMS, type ApproachForm } from "../../nc/words.ts";
import { approachFields, isPolar, shapeOf } from "../../program/motion/approach-fields.ts";
import type { Bounds, Place } from "../../view/camera.ts";
import { approachDrawing } from "../../view/approach/drawing.ts";
import { nearby } from "../../view/approach/forms.ts";
import { cameraFor, onScreen, planeFrameOf } from "../../view/approach/frame.ts";
import { px } from "../../view/help/marks.ts";
import { approachWords } from "../../app/fields/blocks/approach-words.ts";
import { PointDots } from "../../app/pictures/plane/PointDot.tsx";
import { approachSpeech } from "../../app/pictures/plane/speech.ts";
import { HelpMarks } from "../../app/pictures/help/HelpMarks.tsx";
import { useIssueText } from "../../app/calculation/issue-text.ts";
import { lengthsOf } from "../../app/calculation/lengths.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { formAtValues, namedAt, sizedWords, type FormAtValue, type SizedWord } from "./form-values.ts";
import { GuideButton } from "./GuideButton.tsx";
import { GlossaryText, GlossaryList, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";
import { keepFocus } from "./keep-focus.ts";
import { applyToApproach } from "./apply-value.ts";
import { useFormSource, type FormSource } from "./use-form-source.ts";
import "../../app/pictures/help/help.css";
import "../../app/pictures/plane/approach.css";
import { Message } from "../../app/base/Message.tsx";

const SIZE = { width: 330, height: 220 };
const MARGIN = { left: 24, right: 24, top: 24, bottom: 24 };
/** Farther elements of the contour are left out of the picture, mm. */
const FARTHEST = 200;
/** The name of a form's page, and of the form. */
const formPage = (form: ApproachForm, departing: boolean): string =>
  `${departing ? "dep" : "appr"}-${form.toLowerCase()}`;
const formName = (form: ApproachForm, departing: boolean): string => `${departing ? "DEP" : "APPR"} ${form}`;

/** All forms in order; a departure names a point, so it has a polar form only as LCT. */
const ALL_FORMS = [false, true].flatMap((departing) =>
  APPROACH_FORMS.filter((form) => !departing || !isPolar(form) || shapeOf(form) === "LCT").map((form) => ({
    form,
    departing,
  })),
);

/** The form of a page name; null if there is none. */
export const formOfPage = (page: string): { readonly form: ApproachForm; readonly departing: boolean } | null =>
  ALL_FORMS.find(({ form, departing }) => formPage(form, departing) === page) ?? null;

/** The common bounds of all pictures of a word. */
const unitedBounds = (all: readonly Bounds[]): Bounds => ({
  left: Math.min(...all.map(({ left }) => left)),
  right: Math.max(...all.map(({ right }) => right)),
  low: Math.min(...all.map(({ low }) => low)),
  high: Math.max(...all.map(({ high }) => high)),
});

interface CardProps {
  readonly word: SizedWord;
  readonly form: FormAtValue;
  readonly source: FormSource;
  readonly frame: Bounds;
  readonly size: string;
}

/** The pole, and the line from it to the point that a block names. */
const PolarPlace = ({ from, to }: { readonly from: Place; readonly to: Place }) => (
  <>
    <path className="form-polar" d={`M${px(from.x)} ${px(from.y)}L${px(to.x)} ${px(to.y)}`} />
    <circle className="form-pole" cx={px(from.x)} cy={px(from.y)} r={4} />
    <text className="form-pole-name" x={px(from.x + 8)} y={px(from.y + 12)}>
      CC
    </text>
  </>
);

/** A form with one value: its picture with its points, and the length of its path. */
function FormValue({ word, form, source, frame, size }: CardProps) {
  const t = useTexts("guide");
  const places = useTexts("guide-places");
  const advice = useTexts("advice");
  const { approach: words } = useTexts();
  const language = useSettings((s) => s.language),
    lengths = useMemo(() => lengthsOf(language, "mm"), [language]);
  const issueText = useIssueText();
  const id = useId();
  const { request, result, value, isUsual } = form;
  const {
    line,
    context: { plane: working, tip, pole },
  } = source;
  const speech = approachSpeech(lengths, working, tip);
  const drawing = useMemo(() => {
    const contour = nearby(form.contour, request.departing, FARTHEST);
    return approachDrawing({
      result,
      contour,
      centre: compensate(contour, request.side, request.toolRadius).pieces.map(({ segment }) => segment),
      toolRadius: request.toolRadius,
      rapidBefore: source.rapidBefore,
      active: word,
      size: SIZE,
      small: true,
      speech: approachSpeech(lengths, working, tip),
      camera: cameraFor(frame, SIZE, MARGIN),
    });
  }, [result, request, form.contour, source.rapidBefore, word, lengths, frame, working, tip]);
  const named = isPolar(source.form) ? namedAt(form, source.context) : null;
  const text = formatNumber(language, value);
  const way = result.legs.reduce((sum, { segment }) => sum + plane.lengthOf(segment), 0);
  const points = drawing.points
    .filter(({ names }) => names.length > 0)
    .map((p) => words.point(p.names.join(" = "), pointText(p, speech)))
    .join(", ");
  const [issue] = result.issues;
  return (
    <li className="value-card" data-usual={isUsual || undefined}>
      <h3>
        <span className="value-size">{size}</span>
        <span className="number value-shown">
          {word} {text}
        </span>
        {isUsual && line !== null && <span className="small soft">{t.values.yours}</span>}
      </h3>
      <svg
        className="guide-form help-picture approach-picture"
        role="img"
        aria-label={words.picture(`${formName(source.form, request.departing)} ${word}${text}`, points)}
        viewBox={`0 0 ${SIZE.width} ${SIZE.height}`}
      >
        <HelpMarks marks={drawing.marks} id={id} />
        {pole && named && <PolarPlace from={onScreen(drawing.camera, pole)} to={onScreen(drawing.camera, named)} />}
        <PointDots points={drawing.points} />
      </svg>
      <dl className="value-facts">
        <div>
          <dt>{places.form.way}</dt>
          <dd className="number">{t.millimetres(formatNumber(language, way, 1))}</dd>
        </div>
        {(["PH", "PN"] as const).map((name) => {
          const at = result.points[name];
          return (
            at && (
              <div key={name}>
                <dt>{name}</dt>
                <dd className="number">{speech.point(at)}</dd>
              </div>
            )
          );
        })}
      </dl>
      {issue && <Message tone={issue.severity}>{issueText(issue)}</Message>}
      {line !== null && !isUsual && !issue && (
        <button
          type="button"
          className="button value-take"
          onClick={(event) => {
            keepFocus(event.currentTarget, "section");
            void applyToApproach(line, word, value);
          }}
        >
          {advice.take(`${word} = ${text}`)}
        </button>
      )}
    </li>
  );
}

/** A form at a small, the default and a large value of one of its words. */
function FormValues({ word, source }: { readonly word: SizedWord; readonly source: FormSource }) {
  const t = useTexts("guide");
  const { approach: words } = useTexts();
  const { prompt, about } = words.words[word];
  const shown = useMemo(() => {
    const forms = formAtValues(source, word);
    const { toolRadius } = source.request,
      { pole } = source.context;
    const frames = forms.map(({ result, request: { element } }) => planeFrameOf(result, element, toolRadius));
    const at = pole && isPolar(source.form) ? [{ left: pole.x, right: pole.x, low: pole.y, high: pole.y }] : [];
    return { forms, frame: unitedBounds([...frames, ...at]) };
  }, [source, word]);
  const sizes = [t.values.small, t.values.usual, t.values.large];
  return (
    <section className="guide-values" aria-label={prompt}>
      <h2>
        <span className="number">{word}</span> {prompt}
      </h2>
      <p className="soft">{about}</p>
      <ol className="value-cards">
        {shown.forms.map((form, i) => (
          <FormValue
            key={form.value}
            word={word}
            form={form}
            source={source}
            frame={shown.frame}
            size={sizes[i] ?? ""}
          />
        ))}
      </ol>
    </section>
  );
}

/** The page of a form of approach or departure: its points, sizes and dangers. */
export function FormPage({
  form,
  departing,
  word,
}: {
  readonly form: ApproachForm;
  readonly departing: boolean;
  readonly word: string | null;
}) {
  const t = useTexts("guide");
  const { form: places, approach: title } = useTexts("guide-places");
  const { approach: words } = useTexts();
  const source = useFormSource(form, departing),
    shape = shapeOf(form);
  if (!source) return <h1>{t.missing}</h1>;
  const points: readonly Exclude<PointName, never>[] = departing ? ["PE", "PN"] : ["PS", "PH", "PA"];
  const all = sizedWords(source.request, isPolar(form));
  const sized = all.toSorted((a, b) => Number(b === word) - Number(a === word));
  const asked = approachFields(form, departing, source.context.plane).find(({ id }) => id === word);
  const wrong = [places.mistakes[shape], places.mistakes.all];
  return (
    <GlossaryScope texts={[words.shapes[shape].about, ...(departing ? [places.leaving] : places.dangers), ...wrong]}>
      <header className="guide-head">
        <p className="soft">{title}</p>
        <h1>
          <span className="number prompt-q">{formName(form, departing)}</span> {words.shapes[shape].name}
        </h1>
        <p>
          <GlossaryText text={words.shapes[shape].about} />
        </p>
        {isPolar(form) && <p>{places.polar}</p>}
        {asked && !sized.some((each) => each === word) && (
          <p>
            <b className="number">{word === "SIDE" ? "RL/RR" : word}</b>{" "}
            {approachWords(words, asked.id, { departing, plane: source.context.plane }).about}
          </p>
        )}
        <p className="soft">{source.line === null ? places.sampleLead : places.ownLead}</p>
      </header>
      {sized.map((each) => (
        <FormValues key={each} word={each} source={source} />
      ))}
      <div className="guide-columns">
        <section aria-label={places.points}>
          <h2>{places.points}</h2>
          <dl className="guide-points">
            {points.map((name) => (
              <div key={name}>
                <dt>
                  <b className="number">{name}</b> {words.points[name]}
                </dt>
                <dd>{places.of[name]}</dd>
              </div>
            ))}
          </dl>
        </section>
        {departing ? (
          <p className="guide-danger">
            <GlossaryText text={places.leaving} />
          </p>
        ) : (
          <section className="guide-danger" aria-label={places.danger}>
            <h2>{places.danger}</h2>
            <GlossaryList texts={places.dangers} />
          </section>
        )}
      </div>
      <section className="guide-mistakes" aria-label={t.mistakes}>
        <h2>{t.mistakes}</h2>
        <GlossaryList texts={wrong} />
      </section>
      <section aria-label={places.others}>
        <h2>{places.others}</h2>
        <ul className="guide-links">
          <FormLinks but={formPage(form, departing)} />
        </ul>
      </section>
    </GlossaryScope>
  );
}

/** The links to the pages of the eight forms, and of their polar versions. */
export function FormLinks({ but = null }: { readonly but?: string | null }) {
  const { approach: words } = useTexts();
  return ALL_FORMS.filter(({ form, departing }) => formPage(form, departing) !== but).map(({ form, departing }) => (
    <GuideButton key={formPage(form, departing)} to={["guide", formPage(form, departing)]}>
      <b className="number">{formName(form, departing)}</b> {words.shapes[shapeOf(form)].name}
    </GuideButton>
  ));
}
