/** Hands content to the browser's downloads. */
function download(content: BlobPart, type: string, file: string): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = file;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** A file of bytes, as they are. */
export const downloadBytes = (bytes: BlobPart, file: string): void => download(bytes, "application/octet-stream", file);

/** A file of text. */
export const downloadText = (text: string, file: string): void => download(text, "text/plain;charset=utf-8", file);
