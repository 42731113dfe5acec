// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Puts figures where the page has room for them and draws each when it comes near the screen.
import { FigureCard } from './figure_card.js';
import { findCase, report } from './data.js';

const cards = [];
const drawn = new IntersectionObserver((entries) => {
  for (const entry of entries) {
    if (entry.isIntersecting) cards.find((card) => card.element === entry.target)?.draw();
  }
}, { rootMargin: '400px' });
const sized = new ResizeObserver((entries) => {
  for (const entry of entries) cards.find((card) => card.place === entry.target)?.resize();
});

function fillPlace(place) {
  const { case: caseName, topic } = place.dataset;
  const figures = caseName ? findCase(caseName).figures : report.comparisons;
  for (const figure of figures.filter((one) => one.topic === topic)) {
    const card = new FigureCard(figure, caseName);
    card.caseName = caseName;
    cards.push(card);
    place.append(card.element);
    drawn.observe(card.element);
    sized.observe(card.place);
  }
}

export function fillFigurePlaces() {
  document.querySelectorAll('.figures').forEach(fillPlace);
  // What is hidden has no size to be drawn at.
  window.addEventListener('beforeprint', () => cards.filter((card) => card.element.offsetParent).forEach((card) => card.draw()));
}

/** Moves the time cursor of every figure of a case. */
export function showMoment(caseName, moment) {
  for (const card of cards) if (card.caseName === caseName) card.setTime(moment);
}
