function answer = answer_to(words)
% What the program answers to these words of its command line.
  answer = jsondecode(swayaw.internal.call_program([words, {'--json'}]));
end
