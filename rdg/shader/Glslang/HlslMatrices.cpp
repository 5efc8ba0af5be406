// Matrices as the front end takes them: those of bool as those of int, made of any parts, multiplied as integers.
#include "HlslRewrites.h"

#include <algorithm>
#include <map>

namespace Drydock
{

std::string GetHlslElement(const std::string& Value, const FHlslNumeric& Type, int Index)
{
	if (Type.IsMatrix())
	{
		return Value + "[" + std::to_string(Index / Type.Columns) + "][" + std::to_string(Index % Type.Columns) + "]";
	}
	return Type.Columns ? Value + "[" + std::to_string(Index) + "]" : Value;
}

namespace
{

/** Rows and columns of a factor: a vector is a row on the left, a column on the right. */
struct FShape
{
	FShape(const FHlslNumeric& Type, bool bLeft)
		: Rows(Type.IsMatrix() ? Type.Rows
			   : bLeft         ? 1
							   : Type.Columns)
		, Columns(Type.IsMatrix() ? Type.Columns
				  : bLeft         ? Type.Columns
								  : 1)
	{
	}
	int Rows;
	int Columns;
};

class FMatrixRewriter
{
public:
	FMatrixRewriter(FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Symbols(InSymbols)
		, Errors(OutErrors)
	{
	}

	bool Run()
	{
		for (size_t At = 0; At < Text.Size(); ++At)
		{
			if (!Text.IsWord(At))
			{
				continue;
			}
			const bool bCall = Text.Is(At + 1, "(") && Text.FindClose(At + 1) < Text.Size();
			const bool bOwn = bCall && Symbols.FindFunctions(Text[At].Text);
			const std::optional<FHlslNumeric> Type = ParseHlslNumeric(Text[At].Text);
			if (Type && Type->IsMatrix())
			{
				RewriteType(*Type, At, bCall);
			}
			else if (bCall && !bOwn && (Text.Is(At, "and") || Text.Is(At, "or")))
			{
				Join(At);
			}
			else if (bCall && !bOwn && Text.Is(At, "mul"))
			{
				Multiply(At);
			}
			else if (bCall && !bOwn && Text.Is(At, "transpose"))
			{
				Transpose(At);
			}
			else if (bCall && !bOwn && Text.Is(At, "asuint"))
			{
				Split(At);
			}
			else if (Text.Is(At + 1, "=") && Text.Is(At + 2, "{") && Text.FindClose(At + 2) < Text.Size())
			{
				const FHlslVariable* Variable = Symbols.FindVariable(Text[At].Text, At);
				const std::optional<FHlslNumeric> Of =
					Variable && !Variable->bArray ? ParseHlslNumeric(Variable->Type) : std::nullopt;
				if (Of && Of->IsMatrix())
				{
					Make(*Of, At + 2, At + 2);
				}
			}
		}
		return Edits.Apply(Text, Functions);
	}

private:
	/** True for integers of 16 or 64 bits: the front end makes no matrices of these. */
	static bool IsSizedInteger(const FHlslNumeric& Type)
	{
		return Type.Scalar == "int16_t" || Type.Scalar == "uint16_t" || Type.Scalar == "int64_t" ||
			   Type.Scalar == "uint64_t";
	}

	/** The front end crashes at matrices of bool. */
	static FHlslNumeric GetStored(FHlslNumeric Type)
	{
		Type.Scalar = Type.IsMatrix() && Type.Scalar == "bool" ? "int" : Type.Scalar;
		return Type;
	}

	void RewriteType(const FHlslNumeric& Type, size_t At, bool bCall)
	{
		const bool bCast = !bCall && At > 0 && Text.Is(At - 1, "(") && Text.Is(At + 1, ")");
		if (bCall && Make(Type, At, At + 1))
		{
			return;
		}
		if (Type.Scalar == "bool" && (bCall || (bCast && !Text.IsWord(At - 2))))
		{
			Errors.push_back(Text.MakeError(
				At, "a conversion to " + Type.GetName() + " is not supported here: compare the elements with 0"));
		}
		else if (Type.Scalar == "bool")
		{
			Edits.Replace(At, At + 1, GetStored(Type).GetName());
		}
	}

	/** The types of the arguments of a call or list, empty where one is not known. */
	std::vector<FHlslNumeric> GetParts(size_t Open) const
	{
		std::vector<FHlslNumeric> Parts;
		const size_t Close = Text.FindClose(Open);
		for (size_t Begin = Open + 1, At = Begin; At <= Close; ++At)
		{
			if (At < Close && !Text.Is(At, ","))
			{
				At = std::max(At, Text.FindClose(At));
				continue;
			}
			const std::optional<FHlslNumeric> Part = ParseHlslNumeric(Symbols.GetType(Begin, At));
			if (!Part)
			{
				return {};
			}
			Parts.push_back(*Part);
			Begin = At + 1;
		}
		return Parts;
	}

	/** float3x2(float3, float3) and `float2x2 M = {V, 1, 2}`: elements are taken row by row out of whatever parts there
	 * are. The front end knows scalars for all, or a vector for each row. */
	bool Make(const FHlslNumeric& Type, size_t First, size_t Open)
	{
		const std::vector<FHlslNumeric> Parts = GetParts(Open);
		int Count = 0;
		bool bRows = true;
		bool bScalars = true;
		for (const FHlslNumeric& Part : Parts)
		{
			Count += Part.GetCount();
			bRows = bRows && !Part.IsMatrix() && Part.Columns == Type.Columns;
			bScalars = bScalars && Part.Columns == 0;
		}
		const bool bThin = Type.Rows == 1 || Type.Columns == 1 || Type.Scalar == "bool" || IsSizedInteger(Type);
		const bool bSame = Parts.size() == 1 && Parts[0].IsMatrix() && Type.Scalar != "bool";
		if (Parts.empty() || Count != Type.GetCount() || ((bScalars || bRows) && !bThin) || bSame)
		{
			return false;
		}
		const std::string Matrix = GetStored(Type).GetName();
		std::string Name = "Drydock_" + Type.GetName();
		std::string Arguments;
		std::string Body = Matrix + " R;";
		int Element = 0;
		for (size_t i = 0; i < Parts.size(); ++i)
		{
			const std::string Argument = "A" + std::to_string(i);
			Arguments += (i ? ", " : "") + GetStored(Parts[i]).GetName() + " " + Argument;
			Name += "_" + Parts[i].GetName();
			for (int k = 0; k < Parts[i].GetCount(); ++k, ++Element)
			{
				const std::string Value = GetHlslElement(Argument, Parts[i], k);
				Body += " " + GetHlslElement("R", Type, Element) + " = " +
						(Type.Scalar == "bool" ? "int(bool(" + Value + "))" : Value) + ";";
			}
		}
		Functions[Name] = Matrix + " " + Name + "(" + Arguments + ") { " + Body + " return R; }";
		Edits.Replace(First, Open + 1, Name + "(");
		if (Text.Is(Open, "{"))
		{
			const size_t Close = Text.FindClose(Open);
			Edits.Replace(Close, Close + 1, ")");
		}
		return true;
	}

	/** and(A, B) of matrices, by elements. */
	void Join(size_t At)
	{
		const std::vector<FHlslNumeric> Parts = GetParts(At + 1);
		if (Parts.size() != 2 || !Parts[0].IsMatrix() || Parts[0].GetName() != Parts[1].GetName())
		{
			return;
		}
		const std::string Matrix = GetStored(Parts[0]).GetName();
		const std::string Name = Text.Is(At, "and") ? "DrydockAnd" : "DrydockOr";
		std::string Body = Matrix + " " + Name + "(" + Matrix + " A, " + Matrix + " B) { " + Matrix + " R;";
		for (int i = 0; i < Parts[0].GetCount(); ++i)
		{
			Body += " " + GetHlslElement("R", Parts[0], i) + " = int(bool(" + GetHlslElement("A", Parts[0], i) + ")" +
					(Text.Is(At, "and") ? " && bool(" : " || bool(") + GetHlslElement("B", Parts[0], i) + "));";
		}
		Functions[Name + Matrix] = Body + " return R; }";
		Edits.Replace(At, At + 1, Name);
	}

	/** mul(A, B) of integers. */
	void Multiply(size_t At)
	{
		const std::vector<FHlslNumeric> Parts = GetParts(At + 1);
		const bool bMatrix = Parts.size() == 2 && (Parts[0].IsMatrix() || Parts[1].IsMatrix());
		const bool bSized = bMatrix && IsSizedInteger(Parts[0]) && IsSizedInteger(Parts[1]);
		if (bSized && (!Parts[0].Columns || !Parts[1].Columns))
		{
			Scale(At, Parts[0], Parts[1]);
			return;
		}
		const bool bIntegers = bSized || (bMatrix && Parts[0].IsInteger() && Parts[1].IsInteger());
		if (!bIntegers || !Parts[0].Columns || !Parts[1].Columns)
		{
			return;
		}
		const FShape Left(Parts[0], true);
		const FShape Right(Parts[1], false);
		FHlslNumeric Result{Parts[0].Scalar[0] == 'u' ? Parts[0].Scalar : Parts[1].Scalar, Left.Rows, Right.Columns};
		if (!Parts[0].IsMatrix() || !Parts[1].IsMatrix())
		{
			Result = {Result.Scalar, 0, Left.Rows * Right.Columns};
		}
		std::string Body = Result.GetName() + " DrydockMul(" + Parts[0].GetName() + " A, " + Parts[1].GetName() +
						   " B) { " + Result.GetName() + " R;";
		for (int i = 0; i < Result.GetCount() && Left.Columns == Right.Rows; ++i)
		{
			Body += " " + GetHlslElement("R", Result, i) + " = ";
			for (int k = 0; k < Left.Columns; ++k)
			{
				Body += (k ? " + " : "") + GetHlslElement("A", Parts[0], i / Right.Columns * Left.Columns + k) + " * " +
						GetHlslElement("B", Parts[1], k * Right.Columns + i % Right.Columns);
			}
			Body += ";";
		}
		if (Left.Columns == Right.Rows)
		{
			Functions["DrydockMul" + Parts[0].GetName() + Parts[1].GetName()] = Body + " return R; }";
			Edits.Replace(At, At + 1, "DrydockMul");
		}
	}

	/** mul of a number and a matrix. */
	void Scale(size_t At, const FHlslNumeric& A, const FHlslNumeric& B)
	{
		const FHlslNumeric Result = A.IsMatrix() ? A : B;
		std::string Body = Result.GetName() + " DrydockMul(" + A.GetName() + " A, " + B.GetName() + " B) { " +
						   Result.GetName() + " R;";
		for (int i = 0; i < Result.GetCount(); ++i)
		{
			Body += " " + GetHlslElement("R", Result, i) + " = " + GetHlslElement("A", A, i) + " * " +
					GetHlslElement("B", B, i) + ";";
		}
		Functions["DrydockMul" + A.GetName() + B.GetName()] = Body + " return R; }";
		Edits.Replace(At, At + 1, "DrydockMul");
	}

	/** asuint(M, Low, High) of doubles, row by row. */
	void Split(size_t At)
	{
		const std::vector<FHlslNumeric> Parts = GetParts(At + 1);
		if (Parts.size() != 3 || !Parts[0].IsMatrix() || Parts[0].Scalar != "double")
		{
			return;
		}
		const std::string Bits = FHlslNumeric{"uint", Parts[0].Rows, Parts[0].Columns}.GetName();
		std::string Body =
			"void DrydockSplit(" + Parts[0].GetName() + " A, out " + Bits + " Low, out " + Bits + " High) {";
		for (int i = 0; i < Parts[0].GetCount(); ++i)
		{
			const std::string Number = std::to_string(i);
			Body += " uint L" + Number + "; uint H" + Number + "; asuint(" + GetHlslElement("A", Parts[0], i) + ", L" +
					Number + ", H" + Number + "); " + GetHlslElement("Low", Parts[0], i) + " = L" + Number + "; " +
					GetHlslElement("High", Parts[0], i) + " = H" + Number + ";";
		}
		Functions["DrydockSplit" + Bits] = Body + " }";
		Edits.Replace(At, At + 1, "DrydockSplit");
	}

	/** transpose of such matrices. */
	void Transpose(size_t At)
	{
		const std::vector<FHlslNumeric> Parts = GetParts(At + 1);
		if (Parts.size() != 1 || !Parts[0].IsMatrix() || !IsSizedInteger(Parts[0]))
		{
			return;
		}
		const FHlslNumeric Result{Parts[0].Scalar, Parts[0].Columns, Parts[0].Rows};
		std::string Body =
			Result.GetName() + " DrydockTranspose(" + Parts[0].GetName() + " A) { " + Result.GetName() + " R;";
		for (int i = 0; i < Result.GetCount(); ++i)
		{
			Body += " " + GetHlslElement("R", Result, i) + " = " +
					GetHlslElement("A", Parts[0], i % Result.Columns * Parts[0].Columns + i / Result.Columns) + ";";
		}
		Functions["DrydockTranspose" + Parts[0].GetName()] = Body + " return R; }";
		Edits.Replace(At, At + 1, "DrydockTranspose");
	}

	FHlslText& Text;
	const FHlslSymbols& Symbols;
	std::vector<FDiagnostic>& Errors;
	std::map<std::string, std::string> Functions; // that stand before the text
	FHlslEdits Edits;
};

} // namespace

bool RewriteMatrices(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors)
{
	return FMatrixRewriter(Text, Symbols, Errors).Run();
}

} // namespace Drydock
