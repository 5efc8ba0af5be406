// Writes a matrix as JSON.
#include "Matrix/MatrixSummary.h"
#include "Matrix/MatrixTable.h"
#include "Matrix/MatrixVersions.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"

#include "Diagnostics.h"

#include <array>

namespace Drydock
{

namespace
{

void WriteMessage(FJsonWriter& Writer, const FMatrixMessage& Message)
{
	Writer.Object({{"code", Message.Code > 0 ? std::optional(FormatCode(Message.Code)) : std::nullopt},
		{"file", Message.File}, {"line", Message.Line}, {"where", Message.Where}, {"text", Message.Text}});
}

void WriteFirstError(FJsonWriter& Writer, const std::optional<FMatrixMessage>& Error)
{
	Writer.Key("firstError");
	if (Error)
	{
		WriteMessage(Writer, *Error);
		return;
	}
	Writer.Null();
}

void WriteMessages(FJsonWriter& Writer, const char* Key, const std::vector<FMatrixMessage>& Messages)
{
	Writer.Array(Key, Messages, [&](const FMatrixMessage& Message) { WriteMessage(Writer, Message); });
}

void WriteTexts(FJsonWriter& Writer, const char* Key, const std::vector<std::string>& Texts)
{
	Writer.Array(Key, Texts, [&](const std::string& Text) { Writer.Value(Text); });
}

std::optional<std::string> DescribeOptional(const std::optional<int>& Minor)
{
	return Minor ? std::optional(DescribeVersion(*Minor)) : std::nullopt;
}

void WriteRun(FJsonWriter& Writer, const std::optional<FMatrixRun>& Run)
{
	Writer.Key("run");
	if (!Run)
	{
		Writer.Null();
		return;
	}
	Writer.BeginObject();
	Writer.Member("exitCode", Run->ExitCode);
	Writer.Member("end", Run->Ran() ? std::nullopt : std::optional(DescribeEnd(*Run)));
	WriteFirstError(Writer, Run->FirstError);
	WriteMessages(Writer, "warnings", Run->Warnings);
	WriteTexts(Writer, "extensions", Run->Extensions);
	Writer.Member("folder", Run->Folder);
	Writer.EndObject();
}

void WritePicture(FJsonWriter& Writer, const std::optional<FMatrixPicture>& Picture)
{
	Writer.Key("picture");
	if (!Picture)
	{
		Writer.Null();
		return;
	}
	Writer.BeginObject();
	Writer.Members({{"fingerprint", Picture->Fingerprint}, {"before", DescribeOptional(Picture->Before)},
		{"same", Picture->Before ? std::optional(!Picture->Difference) : std::nullopt}});
	if (Picture->Difference && !Picture->Difference->bOtherSize)
	{
		Writer.Members({{"max", Picture->Difference->Max}, {"pixels", Picture->Difference->NumPixels},
			{"first", std::array{Picture->Difference->X, Picture->Difference->Y}}});
	}
	Writer.Member("sameAs", DescribeOptional(Picture->SameAs));
	Writer.EndObject();
}

void WriteRow(FJsonWriter& Writer, const FMatrixRow& Row)
{
	Writer.BeginObject();
	Writer.Members({{"engine", DescribeVersion(Row.Minor)}, {"builds", Row.Build.bBuilt}});
	WriteFirstError(Writer, Row.Build.FirstError);
	WriteMessages(Writer, "compilerWarnings", Row.Build.Warnings);
	Writer.Key("inEngine").BeginObject();
	Writer.Member("answer", FormatInEngine(Row.Build));
	WriteTexts(Writer, "messages", Row.Build.InEngine);
	Writer.EndObject();
	WriteTexts(Writer, "notes", Row.Build.Notes);
	Writer.Members({{"library", Row.Build.Library}, {"log", Row.Build.Log}});
	WriteRun(Writer, Row.Run);
	WritePicture(Writer, Row.Picture);
	Writer.Key("firstDifference");
	if (Row.FirstDifference)
	{
		Writer.Object({{"pass", Row.FirstDifference->Pass}, {"what", Row.FirstDifference->What}});
	}
	else
	{
		Writer.Null();
	}
	Writer.EndObject();
}

} // namespace

std::string MakeMatrixJson(const FVersionMatrix& Matrix)
{
	FJsonWriter Writer('{');
	Writer.Members({{"plugin", Matrix.Name}, {"folder", Matrix.Folder}, {"config", Matrix.Config}});
	Writer.Array("versions", Matrix.Rows, [&](const FMatrixRow& Row) { WriteRow(Writer, Row); });
	Writer.Member("summary", SummarizeMatrix(Matrix));
	WriteTexts(Writer, "advice", AdviseOnMatrix(Matrix));
	Writer.Member("passed", GetMatrixExitCode(Matrix) == ExitDone);
	return Writer.GetText();
}

} // namespace Drydock
