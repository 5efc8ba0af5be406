// Declares what the readers of engine text share: words, spaces, descriptions of a place.
#pragma once

#include "PostProcessSettingsTextErrors.h"

#include <string>

namespace Drydock
{

/** Moves Offset over spaces, and over line breaks too. */
void SkipEngineTextSpace(const std::string& Text, size_t& Offset);

/** Describes the text at Offset, for messages: `'='`, `abc`, `the end of the text`. */
std::string DescribeEngineTextAt(const std::string& Text, size_t Offset);

/** Whether a bare word ends before this: space, quote or one of `(),=[]`. */
bool EndsEngineTextWord(char Character);

/** A bare word at Offset: up to a space, a quote or one of `(),=[]`. */
std::string ReadEngineTextWord(const std::string& Text, size_t Offset);

/** Letters, digits and underscores, no digit first. */
bool IsEngineTextName(const std::string& Word);

/** Reports a text that is not UTF-8, once. */
bool CheckEngineTextEncoding(const std::string& Text, FSettingsTextMessages& Messages);

} // namespace Drydock
