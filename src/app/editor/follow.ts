import { EditorView } from "@codemirror/view";
import { shownBlock } from "../approach/shown-view.ts";
import { useOutcome, type Outcome } from "../engine/outcome.ts";
import { showSection, usePlace } from "../place.ts";
import { playback } from "../playback.ts";
import { usePrompted } from "../prompted.ts";
import { texts } from "../settings/loaded-texts.ts";
import { useSettings } from "../settings/settings.ts";
import { useEditor } from "../store.ts";
import { setRunning } from "./block-marks.ts";
import { problemsOfBlock, readingOfBlock, withPrompt } from "./block-prompts.ts";
import { diagnosticsOf } from "./diagnostics.ts";
import { inWords } from "./editor-extensions.ts";
import { useOpenBlock } from "./open-block.ts";
import { blockRange } from "./reading-field.ts";
import { WIDE } from "./wide.ts";
import { dispatchEdit, editProgram, openBlock, programText, sessionView, useSession } from "./session.ts";

/** True when a result was made from the text as it stands now. */
const isPresent = (outcome: Outcome | null): outcome is Outcome =>
  outcome !== null && outcome.text === useEditor.getState().program?.text && outcome.text === programText();

/** What is being typed into the prompts of the open block; the text has it as soon as it can be read. */
let typed: Readonly<Record<string, string>> = {};
let typedIn = -1;
let typing = false;

function setPrompt(q: string, text: string): void {
  const { reading, index } = useSession.getState();
  typed = { ...typed, [q]: text };
  typing = true;
  editProgram(withPrompt(reading.program, index, q, text), `block ${index} ${q}`);
  typing = false;
  refresh();
}

/** Dresses the open block for the dialog. */
function refresh(): void {
  const { reading, index } = useSession.getState();
  if (index !== typedIn) typed = {};
  typedIn = index;
  const read = readingOfBlock(reading.program, index, typed);
  const problems = problemsOfBlock(reading.program, index, read, useOutcome.getState().newest?.run.issues ?? []);
  useOpenBlock.setState({ read, problems });
  usePrompted.setState({ block: read && { job: read.job, problems, setPrompt } });
}

function followSession(): () => void {
  return useSession.subscribe((now, before) => {
    if (now.reading !== before.reading && !typing) typed = {};
    if (now.pointed !== before.pointed && matchMedia(WIDE).matches) showSection("block");
    if (now.reading === before.reading && now.index === before.index && now.opened === before.opened) return;
    refresh();
    if (now.opened === before.opened) return;
    const { read } = useOpenBlock.getState();
    const q = read && (now.parameter !== null && now.parameter in read.cycle.params ? now.parameter : (Object.keys(read.cycle.params)[0] ?? null));
    if (read && q) usePlace.setState({ prompt: q, before: read.draft[q] ?? "", field: null });
  });
}

/** The text goes along with the prompts. */
function followPrompt(): () => void {
  return usePlace.subscribe((now, before) => {
    const { index, parameter } = useSession.getState();
    if (now.prompt !== before.prompt && now.prompt !== null && now.prompt !== parameter && useOpenBlock.getState().read) openBlock(index, now.prompt, true);
  });
}

function mark(): void {
  const view = sessionView();
  const { newest } = useOutcome.getState();
  if (!view || !isPresent(newest)) return;
  const { language } = useSettings.getState();
  view.dispatch(diagnosticsOf(view, newest.run.issues, texts(language), language, (spec) => dispatchEdit(spec, null)));
}

function followOutcome(): () => void {
  return useOutcome.subscribe((now, before) => {
    if (now.newest === before.newest) return;
    refresh();
    mark();
  });
}

function followLanguage(): () => void {
  const put = () => {
    const { language } = useSettings.getState();
    sessionView()?.dispatch({ effects: inWords(texts(language), language) });
    mark();
  };
  put();
  return useSettings.subscribe((now, before) => {
    if (now.language !== before.language) put();
  });
}

/** Index of the block whose move stands at the playback's position; null at the start, and where the text has changed since. */
function runningBlock(): number | null {
  const { shown } = useOutcome.getState();
  const { position } = playback.get();
  if (!isPresent(shown) || (position.step === 0 && position.fraction === 0)) return null;
  return shownBlock(shown.run, position.step);
}

function followPlayback(): () => void {
  let marked: number | null = null;
  return playback.subscribe(() => {
    const view = sessionView();
    const next = runningBlock();
    if (!view || next === marked) return;
    marked = next;
    const range = next === null ? null : blockRange(view.state, next);
    view.dispatch({ effects: [setRunning.of(next), ...(range && playback.get().playing ? [EditorView.scrollIntoView(range.from, { y: "nearest", yMargin: 40 })] : [])] });
  });
}

/** From now on text, dialog, marks and animation of the open program go together. */
export function followProgram(): () => void {
  const stops = [followSession(), followPrompt(), followOutcome(), followLanguage(), followPlayback()];
  refresh();
  const { read } = useOpenBlock.getState();
  const first = read && Object.keys(read.cycle.params)[0];
  if (read && first) usePlace.setState({ prompt: first, before: read.draft[first] ?? "", field: null });
  return () => {
    for (const stop of stops) stop();
    usePrompted.setState({ block: null });
    useOpenBlock.setState({ read: null, problems: [] });
    typed = {};
    typedIn = -1;
  };
}
