// The numbers of the messages about engine text, and how they are collected. A number never changes its meaning;
// docs/errors.md explains each one.
#pragma once

#include "Diagnostics.h"
#include "TextPositions.h"

#include <string>
#include <vector>

namespace Drydock
{

enum ESettingsTextError
{
	// DD3: settings
	ErrorTextSyntax = 3001,         // not engine text from here on
	ErrorTextDepth = 3002,          // nested deeper than any settings
	ErrorTextGivenTwice = 3003,     // one field, two values
	ErrorTextWrongType = 3004,      // a value that the field cannot have
	ErrorTextUnknownName = 3005,    // an enum has no such name, a colour no such component
	ErrorTextNotFinite = 3006,      // NaN, infinity, or a number beyond float
	ErrorTextIndex = 3007,          // an index where there is no array, none where there is one, or beyond its end
	ErrorTextBlocks = 3008,         // Begin without End, End without Begin
	ErrorTextNoSettings = 3009,     // an engine text without any post-process settings
	ErrorTextNotUtf8 = 3010,        // not UTF-8: the clipboard was saved in another encoding
	WarnTextInert = 3020,           // values whose override bits are off: kept, without effect
	NoteTextBitWithoutValue = 3021, // override bits on without a value: the default applies
	WarnTextUnknownFields = 3022,   // fields that drydock does not have: kept as text
	WarnTextOutOfRange = 3023,      // outside the setting's clamps; used as it is
	WarnTextDecimals = 3024,        // values that six decimals do not hold
	WarnTextShape = 3025,           // a shape that text or config cannot express
	NoteTextUpgraded = 3026,        // --upgrade changed values
	WarnTextWeightClamped = 3027,   // a blend weight outside 0..1
};

/** Collects messages about one text. Refers to all that it is made from. */
class FSettingsTextMessages
{
public:
	FSettingsTextMessages(const std::string& Text, const std::string& InFile, std::vector<FDiagnostic>& InDiagnostics)
		: Positions(Text)
		, File(InFile)
		, Diagnostics(InDiagnostics)
	{
	}

	void Error(ESettingsTextError Code, size_t Offset, const std::string& Where, const std::string& Message)
	{
		Add(ESeverity::Error, Code, Offset, Where, Message);
	}
	void Warn(ESettingsTextError Code, size_t Offset, const std::string& Where, const std::string& Message)
	{
		Add(ESeverity::Warning, Code, Offset, Where, Message);
	}
	void Note(ESettingsTextError Code, size_t Offset, const std::string& Where, const std::string& Message)
	{
		Add(ESeverity::Note, Code, Offset, Where, Message);
	}

	/** "12:7", for messages that name a second place. */
	std::string Place(size_t Offset) const
	{
		const FTextPosition Position = Positions.Find(Offset);
		return std::to_string(Position.Line) + ":" + std::to_string(Position.Column);
	}

private:
	void Add(ESeverity Severity, ESettingsTextError Code, size_t Offset, const std::string& Where,
		const std::string& Message)
	{
		const FTextPosition Position = Positions.Find(Offset);
		Diagnostics.push_back({Severity, Code, Message, File, Position.Line, Position.Column, Where});
	}

	FTextPositions Positions;
	const std::string& File;
	std::vector<FDiagnostic>& Diagnostics;
};

} // namespace Drydock
