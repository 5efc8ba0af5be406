// Buffers of bytes that are read and written as types (Load<float4>, Store<FItem>), and constant buffers whose struct
// is that of a buffer that is written too.
#include "HlslRewrites.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock
{

namespace
{

constexpr int MaxNumbers = 1024; // of a type that is read or written at once, each is an instruction

class FBufferRewriter
{
public:
	FBufferRewriter(FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Symbols(InSymbols)
		, Errors(OutErrors)
	{
	}

	bool Run()
	{
		for (size_t At = 2; At < Text.Size(); ++At)
		{
			if (Text.Is(At - 1, ".") && (Text.Is(At, "Load") || Text.Is(At, "Store")))
			{
				Access(At);
			}
			else if (Text.Is(At, "ConstantBuffer") && Text.Is(At + 1, "<"))
			{
				DeclareBlock(At);
			}
		}
		const bool bChanged = !Edits.IsEmpty();
		Edits.Apply(Text);
		return bChanged;
	}

private:
	/** A call of Load or Store as it is written. */
	struct FAccess
	{
		std::string Buffer;
		std::string Place; // where the buffer is read: an expression of uint
		bool bLoad = false;
		std::string Words; // the statements
		uint32_t Offset = 0;
		int NumNumbers = 0;
	};

	static std::string GetBits(const FHlslNumeric& Type, const std::string& Value)
	{
		return Type.Scalar == "uint" ? Value
			   : Type.Scalar == "bool"
				   ? "uint" + (Type.Columns ? std::to_string(Type.Columns) : std::string()) + "(" + Value + ")"
				   : "asuint(" + Value + ")";
	}
	static std::string GetValue(const FHlslNumeric& Type, const std::string& Bits)
	{
		return Type.Scalar == "uint"    ? Bits
			   : Type.Scalar == "bool"  ? "(" + Bits + " != 0u)"
			   : Type.Scalar == "float" ? "asfloat(" + Bits + ")"
										: "asint(" + Bits + ")";
	}
	static bool HasWords(const FHlslNumeric& Type)
	{
		return Type.Scalar == "uint" || Type.Scalar == "int" || Type.Scalar == "float" || Type.Scalar == "bool";
	}
	static std::string GetSuffix(int Count) { return Count > 1 ? std::to_string(Count) : std::string(); }

	/** One scalar or vector at Path. */
	static void AccessVector(FAccess& Access, const FHlslNumeric& Type, const std::string& Path)
	{
		const int Count = std::max(Type.Columns, 1);
		const std::string Place = Access.Place + " + " + std::to_string(Access.Offset) + "u";
		Access.Words +=
			Access.bLoad
				? Path + " = " + GetValue(Type, Access.Buffer + ".Load" + GetSuffix(Count) + "(" + Place + ")") + "; "
				: Access.Buffer + ".Store" + GetSuffix(Count) + "(" + Place + ", " + GetBits(Type, Path) + "); ";
		Access.Offset += uint32_t(Count) * 4;
		Access.NumNumbers += Count;
	}

	/** All of a type at Path, in the order of memory, matrices by rows; false where a part is not of 32 bits. */
	bool AccessType(FAccess& Access, const std::string& Type, const std::string& Path, int Depth) const
	{
		if (const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type))
		{
			if (!HasWords(*Numeric))
			{
				return false;
			}
			const FHlslNumeric Row{Numeric->Scalar, 0, Numeric->IsMatrix() ? Numeric->Columns : 0};
			for (int i = 0; i < Numeric->Rows; ++i)
			{
				const std::string Element = Path + "[" + std::to_string(i) + "]";
				const bool bThin = Row.Columns == 1;
				AccessVector(Access, bThin ? FHlslNumeric{Row.Scalar, 0, 0} : Row, bThin ? Element + "[0]" : Element);
			}
			if (!Numeric->IsMatrix())
			{
				AccessVector(Access, *Numeric, Path);
			}
			return true;
		}
		const std::vector<FHlslVariable>* const Members = Symbols.GetMembers(Type);
		if (!Members || Depth > 16)
		{
			return false;
		}
		return std::all_of(Members->begin(), Members->end(),
			[&](const FHlslVariable& Member)
			{ return AccessMember(Access, Member, Path + "." + Text[Member.At].Text, Member.At + 1, Depth + 1); });
	}

	/** A member from its dimension at DimensionAt on. */
	bool AccessMember(
		FAccess& Access, const FHlslVariable& Member, const std::string& Path, size_t DimensionAt, int Depth) const
	{
		if (!Text.Is(DimensionAt, "["))
		{
			return AccessType(Access, Member.Type, Path, Depth);
		}
		const bool bNumber = Text.FindClose(DimensionAt) == DimensionAt + 2;
		const long Count = bNumber ? std::strtol(Text[DimensionAt + 1].Text.c_str(), nullptr, 0) : 0;
		bool bKnown = Count > 0;
		for (long i = 0; i < Count && bKnown && Access.NumNumbers <= MaxNumbers; ++i)
		{
			bKnown = AccessMember(Access, Member, Path + "[" + std::to_string(i) + "]", DimensionAt + 3, Depth);
		}
		return bKnown && Access.NumNumbers <= MaxNumbers;
	}

	/** Buffer.Load<T>(Place), Buffer.Store<T>(Place, Value), and Buffer.Store(Place, Value) of what is not uint. */
	void Access(size_t At)
	{
		const bool bLoad = Text.Is(At, "Load");
		const bool bList = Text.Is(At + 1, "<");
		const size_t First = Symbols.FindChainStart(At - 2);
		const std::string Buffer = Symbols.GetType(First, At - 1);
		const size_t Open = bList ? Text.FindListEnd(At + 1) : At + 1;
		const size_t Close = Text.FindClose(Open);
		if (Buffer.find("ByteAddressBuffer") == std::string::npos || !Text.Is(Open, "(") || Close >= Text.Size())
		{
			return;
		}
		size_t Comma = Open + 1;
		while (Comma < Close && !Text.Is(Comma, ","))
		{
			Comma = std::max(Comma, Text.FindClose(Comma)) + 1;
		}
		size_t TypeEnd = 0;
		const std::string Written = bList    ? Symbols.ReadType(At + 2, TypeEnd)
									: !bLoad ? Symbols.GetType(Comma + 1, Close)
											 : std::string();
		const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Written);
		const std::string Type = Numeric ? Numeric->GetName() : Written;
		// What is stored as an int is what is stored as its bits; a uint is as HLSL's older mode has it.
		if (Type.empty() || (!bList && (!Numeric || (Numeric->Columns == 0 && Numeric->IsInteger()))) ||
			bLoad == (Comma < Close))
		{
			return;
		}
		FAccess Parts{Text.GetText(First, At - 1), "At", bLoad, {}, 0, 0};
		if (!AccessType(Parts, Type, "Value", 0))
		{
			return; // the front end says what it does not know
		}
		const size_t Before = Text.FindDeclaration(At);
		const bool bGlobal = First + 2 == At && Symbols.FindVariable(Text[First].Text, First) &&
							 Symbols.FindVariable(Text[First].Text, First)->bGlobal && Before < Text.Size();
		if (!bGlobal)
		{
			Errors.push_back(
				Text.MakeError(At, Text[At].Text + "<" + Type +
									   "> is known of a buffer that is a parameter of the shader, in a function"));
			return;
		}
		const std::string Name = (bLoad ? "DrydockLoad_" : "DrydockStore_") + Type + "_" + Parts.Buffer;
		if (Functions.insert(Name).second)
		{
			Edits.Insert(Before,
				bLoad ? Type + " " + Name + "(uint At) { " + Type + " Value; " + Parts.Words + "return Value; } "
					  : "void " + Name + "(uint At, " + Type + " Value) { " + Parts.Words + "} ");
		}
		Edits.Replace(First, Open, Name);
	}

	/** ConstantBuffer<S> B; -> cbuffer B_Block { S B; }: with a RWStructuredBuffer<S> the front end takes the two for
	 * one kind of memory, which cannot be written. */
	void DeclareBlock(size_t At)
	{
		size_t Name = 0;
		const std::string Type = Symbols.ReadType(At, Name);
		const std::string Struct = Type.substr(15, Type.size() - 16);
		bool bWritten = false;
		for (size_t i = 0; i + 2 < Text.Size(); ++i)
		{
			bWritten = bWritten || (Text.Is(i, "RWStructuredBuffer") && Text.Is(i + 2, Struct.c_str()));
		}
		size_t End = Name + 1;
		while (End < Text.Size() && !Text.Is(End, ";"))
		{
			End = Text.FindClose(End) + 1;
		}
		if (!bWritten || !Text.IsWord(Name) || Text.Is(Name + 1, "[") || End >= Text.Size())
		{
			return;
		}
		const std::string Variable = Text[Name].Text;
		Edits.Replace(At, Name + 1, "cbuffer " + Variable + "_Block");
		Edits.Replace(End, End + 1, "{ " + Struct + " " + Variable + "; };");
	}

	FHlslText& Text;
	const FHlslSymbols& Symbols;
	std::vector<FDiagnostic>& Errors;
	std::set<std::string> Functions; // that were written
	FHlslEdits Edits;
};

} // namespace

bool RewriteBuffers(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors)
{
	return FBufferRewriter(Text, Symbols, Errors).Run();
}

} // namespace Drydock
