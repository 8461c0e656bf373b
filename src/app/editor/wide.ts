/** Three columns have room for the text beside the view. The same width stands in `layout.css`. */
export const WIDE = "(min-width: 1280px)";
