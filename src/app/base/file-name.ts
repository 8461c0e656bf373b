/** Longest name, characters: in UTF-8 it fits into the 255 bytes of every file system. */
const LONGEST = 60;
const ENDING = /(?:\.[\p{L}\p{N}-]{1,16}){1,2}$/u;
/** Characters of paths and patterns, and those that are invisible or turn the direction of a text. */
const UNFIT = /[\\/:*?"<>|\p{Cc}\p{Cf}\p{Cs}\p{Zl}\p{Zp}]/gu;
/** Names of devices: some systems reject them with any ending. */
const RESERVED = /^(?:CON|PRN|AUX|NUL|CONIN\$|CONOUT\$|(?:COM|LPT)[\d¹²³])\s*(?:\.|$)/i;

const trimmed = (text: string): string => text.replace(/^[. ]+|(?<![. ])[. ]+$/g, "");

/** A name as one part of a path on every system, never hidden. Every file that leaves the page gets its name here. */
export function safeFileName(name: string): string {
  const plain = name.normalize("NFC").replace(UNFIT, "_");
  const ending = ENDING.exec(plain)?.[0] ?? "";
  const whole = [...plain.slice(0, plain.length - ending.length)];
  const stem = trimmed(whole.slice(0, LONGEST - ending.length).join(""));
  const fit = stem + ending;
  return stem === "" || RESERVED.test(fit) ? `_${fit}` : fit;
}

/** The name of a program's file, from its first block. */
export const fileNameOf = (text: string): string => safeFileName(`${/BEGIN PGM (\S+)/.exec(text)?.[1] ?? "PROGRAM"}.h`);
