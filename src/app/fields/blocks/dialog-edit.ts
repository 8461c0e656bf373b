import { Annotation } from "@codemirror/state";

/** Marks a change that a dialog made: the panels follow at once, and the text keeps its place. */
export const dialogEdit = Annotation.define<boolean>();
