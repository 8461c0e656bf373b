import { safeFileName } from "./file-name.ts";

/** Hands content to the browser's downloads; returns the name of the file. */
function download(content: BlobPart, type: string, file: string): string {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement("a");
  link.href = address;
  const name = safeFileName(file);
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
  return name;
}

/** A file of bytes, as they are. */
export const downloadBytes = (bytes: BlobPart, file: string): string =>
  download(bytes, "application/octet-stream", file);

/** A file of text. */
export const downloadText = (text: string, file: string): string => download(text, "text/plain;charset=utf-8", file);
