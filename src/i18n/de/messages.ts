import type { MessagesTexts } from "../en/messages.ts";

export const messages = {} satisfies MessagesTexts;
