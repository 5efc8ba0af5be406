// Keeps whole texts: a config is small, and a text needs no inverse of any edit.
#include "Live/EditHistory.h"

#include "Live/LiveErrors.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

namespace Drydock
{

namespace
{

constexpr size_t MaxHistoryBytes = 64'000'000;
constexpr const char* RecordFormat = "drydock-live";

FError MakeEditError(const std::string& Message)
{
	return FError({.Code = ErrorBadEdit, .Message = Message}, ExitUsage);
}

FError MakeRecordError(const std::string& File, size_t Line, const std::string& Message)
{
	return FError(
		{.Code = ErrorBadRecord, .Message = Message, .File = File, .Line = static_cast<int>(Line), .Where = "--replay"},
		ExitUsage);
}

FJsonValue ReadLine(const std::string& Text, const std::string& File, size_t Line)
{
	std::vector<FDiagnostic> Faults;
	bool bSyntaxError = false;
	FJsonValue Value = ParseJson(Text, File, Faults, bSyntaxError);
	if (bSyntaxError || !Faults.empty() || Value.Type != EJsonType::Object)
	{
		throw MakeRecordError(File, Line, "this line is not a JSON object, as those of a session's record are");
	}
	return Value;
}

std::string MakeFirstLine(const std::string& File, const std::string& Text)
{
	FJsonWriter Writer;
	Writer.Object({{"format", RecordFormat}, {"formatVersion", 1}, {"config", File}, {"text", Text}});
	return Trim(Writer.GetText());
}

/** Does what a line of the record says. */
void ReplayLine(const FJsonValue& Line, const std::string& Text, FEditHistory& History)
{
	using EMove = FEditHistory::EMove;
	if (const FJsonValue* const Edits = Line.Find("edits"))
	{
		const std::vector<FConfigEdit> Read = ReadEdits(*Edits);
		History.Take(History.Edit(Read), EMove::Forward, Text, FEditHistory::MakeDrag(Line.GetString("drag"), Read));
	}
	else if (Line.Find("undo") != nullptr)
	{
		History.Take(History.Undo(), EMove::Undo, Text);
	}
	else if (Line.Find("redo") != nullptr)
	{
		History.Take(History.Redo(), EMove::Redo, Text);
	}
	else if (const FJsonValue* const Pointer = Line.Find("reset"))
	{
		const bool bOne = Pointer->Type == EJsonType::String;
		History.Take(History.Reset(bOne ? std::optional(Pointer->String) : std::nullopt), EMove::Forward, Text);
	}
	else if (const FJsonValue* const Whole = Line.Find("text"))
	{
		History.Take(Whole->String, EMove::Forward, Text);
	}
	else
	{
		throw MakeEditError("expected one of edits, undo, redo, reset and text");
	}
}

} // namespace

std::string FEditHistory::MakeDrag(const std::string& Id, const std::vector<FConfigEdit>& Edits)
{
	std::string Drag = Id;
	for (const FConfigEdit& Edit : Edits)
	{
		if (Id.empty() || !Edit.Value || Edit.Pointer.ends_with("/-"))
		{
			return "";
		}
		Drag += "\n" + Edit.Pointer;
	}
	return Drag;
}

FEditHistory::FEditHistory(std::string InFile, std::string Start)
	: File(std::move(InFile))
	, First(MakeFirstLine(File, Start))
{
	Steps.push_back({std::move(Start), ""});
}

std::string FEditHistory::Edit(const std::vector<FConfigEdit>& Edits) const
{
	return ApplyEdits(GetText(), Edits);
}

std::string FEditHistory::Undo() const
{
	return CanUndo() ? Steps[Now - 1].Text : throw MakeEditError("there is nothing to undo");
}

std::string FEditHistory::Redo() const
{
	return CanRedo() ? Steps[Now + 1].Text : throw MakeEditError("there is nothing to do again");
}

std::string FEditHistory::Reset(const std::optional<std::string>& Pointer) const
{
	if (!Pointer)
	{
		return GetStart();
	}
	const std::optional<std::string> Before = FindPlace(GetStart(), *Pointer);
	const std::optional<std::string> Present = FindPlace(GetText(), *Pointer);
	return Before == Present ? GetText() : ApplyEdits(GetText(), {{*Pointer, Before}});
}

void FEditHistory::Take(const std::string& Text, EMove Move, const std::string& Line, const std::string& Drag)
{
	++Revision;
	const bool bDragged = !Drag.empty() && Drag == LastDrag && Now > 0 && Steps[Now].Drag == Drag && !CanRedo();
	LastDrag = Drag;
	if (bDragged)
	{
		Steps[Now].Text = Text;
		Lines.back() = Line;
		return;
	}
	Lines.push_back(Line);
	if (Move == EMove::Forward)
	{
		Steps.resize(Now + 1);
		Steps.push_back({Text, Drag});
	}
	Now += Move == EMove::Undo ? size_t(-1) : 1;
	NumBytes += Line.size() + Text.size() + Drag.size();
	if (NumBytes > MaxHistoryBytes && Now > 0)
	{
		Steps = {Steps.front(), Steps[Now]};
		Now = 1;
		Lines = {"{\"text\": " + FJsonWriter::Quote(GetText()) + "}"};
		NumBytes = 0;
	}
}

std::string FEditHistory::GetRecord() const
{
	std::string Record = First + "\n";
	for (const std::string& Line : Lines)
	{
		Record += Line + "\n";
	}
	return Record;
}

FEditHistory FEditHistory::Replay(const std::string& Record, const std::string& RecordFile)
{
	const std::vector<std::string> Lines = SplitText(Record);
	const FJsonValue First = Lines.empty() ? FJsonValue() : ReadLine(Lines[0], RecordFile, 1);
	if (First.GetString("format") != RecordFormat || First.GetString("config").empty())
	{
		throw MakeRecordError(RecordFile, 1, "this is not the record of a session of drydock live");
	}
	FEditHistory History(First.GetString("config"), First.GetString("text"));
	for (size_t Index = 1; Index < Lines.size(); ++Index)
	{
		try
		{
			ReplayLine(ReadLine(Lines[Index], RecordFile, Index + 1), Lines[Index], History);
		}
		catch (const FError& Error)
		{
			throw MakeRecordError(RecordFile, Index + 1, Error.GetDiagnostics().front().Message);
		}
	}
	return History;
}

} // namespace Drydock
