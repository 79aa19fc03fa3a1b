// The colours of the page's style sheet, for what is drawn by script.

export type Colour = [number, number, number];

export interface Theme {
  css(name: string): string;
  rgb(name: string): Colour;
  depth: Colour[];
}

const depths = 5;

function parse(colour: string): Colour {
  const digits = colour.trim().replace("#", "");
  return [0, 2, 4].map((i) => parseInt(digits.slice(i, i + 2), 16) / 255) as Colour;
}

export function currentTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const css = (name: string) => style.getPropertyValue(`--${name}`).trim();
  const rgb = (name: string) => parse(css(name));
  const depth = Array.from({ length: depths }, (_, i) => rgb(`depth-${i + 1}`));
  return { css, rgb, depth };
}
