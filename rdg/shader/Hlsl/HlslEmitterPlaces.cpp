// Places: variables, members of buffers, elements and texels, and the parts of them that are read and written.
#include "HlslEmitterImpl.h"

namespace Drydock::Hlsl
{

using namespace Spirv;

bool FEmitter::IsPlace(const FValue& Node)
{
	switch (Node.Kind)
	{
	case EValue::Variable:
		return !Node.Type->IsObject() && (Node.Variable->bWritten || !Node.Variable->Constant);
	case EValue::Element:
		return true;
	case EValue::Member:
	case EValue::Index:
	case EValue::Swizzle:
	case EValue::Elements:
		return IsPlace(*Node.Operands[0]) || Node.Operands[0]->Type->IsObject();
	default:
		return false;
	}
}

FTarget FEmitter::Local(uint32_t Pointer, const FType* Type, uint32_t Storage)
{
	FTarget Target;
	Target.Type = Type;
	Target.Base = Pointer;
	Target.Storage = Storage;
	return Target;
}

/** The part of a value that is not a place: of a copy. */
FTarget FEmitter::Place(const FValue& Node)
{
	switch (Node.Kind)
	{
	case EValue::Variable:
		return Node.Type->IsObject() ? BlockPlace(Node) : VariablePlace(*Node.Variable);
	case EValue::Element:
		return ElementPlace(Node);
	case EValue::Member:
	{
		const FType* const Of = Node.Operands[0]->Type;
		FTarget Target = Of->IsObject() ? BlockPlace(*Node.Operands[0]) : Place(*Node.Operands[0]);
		const FStructType& Struct = *(Of->IsObject() ? Of->Element : Of)->Struct;
		return At(std::move(Target), Module.Int(int32_t(MemberIndex(Struct, Node.Index))), Node.Type);
	}
	case EValue::Index:
		return IndexPlace(Node);
	case EValue::Swizzle:
	{
		FTarget Target = Place(*Node.Operands[0]);
		const bool bOnly = Node.Parts.size() == 1 && Node.Operands[0]->Type->Columns == 1;
		if (bOnly)
		{
			return Target;
		}
		if (Target.Component)
		{
			break;
		}
		if (Node.Parts.size() == 1)
		{
			return Component(std::move(Target), Module.Int(Node.Parts[0]));
		}
		std::vector<uint8_t> Parts;
		for (const uint8_t Part : Node.Parts)
		{
			Parts.push_back(Target.Parts.empty() ? Part : Target.Parts[Part]);
		}
		Target.Parts = std::move(Parts);
		return Target;
	}
	case EValue::Bits:
	{
		FTarget Target = Place(*Node.Operands[0]);
		Target.Bits = Node.Bits;
		return Target;
	}
	case EValue::Elements:
		return MatrixPlace(Place(*Node.Operands[0]), Node.Parts);
	case EValue::Assign:
	case EValue::Modify:
	case EValue::Step:
		if (!Node.bPostfix)
		{
			Value(Node);
			const FValue* Written = Node.Operands[0]; // what stands in it has been run
			while (Written->Kind == EValue::Assign || Written->Kind == EValue::Modify ||
				   (Written->Kind == EValue::Step && !Written->bPostfix))
			{
				Written = Written->Operands[0];
			}
			return Place(*Written);
		}
		break;
	case EValue::Comma:
		Value(*Node.Operands[0]);
		return Place(*Node.Operands[1]);
	default:
		break;
	}
	const uint32_t Id = Value(Node);
	const uint32_t Copy = Temporary(TypeOf(Node.Type));
	Do(OpStore, {Copy, Id});
	return Local(Copy, Node.Type);
}

/** The constant of a variable as memory, for indices that are known at run time only. */
uint32_t FEmitter::Table(const FVariable& Variable)
{
	uint32_t& Id = Frame->Tables[&Variable];
	if (Id == 0)
	{
		Id = Temporary(TypeOf(Variable.Type), Variable.Name);
		AddWords(Frame->Body.Prologue, OpStore, {Id, ConstantOf(Variable.Type, *Variable.Constant)});
	}
	return Id;
}

FTarget FEmitter::VariablePlace(const FVariable& Variable)
{
	if (Variable.Constant && !Variable.bWritten)
	{
		return Local(Table(Variable), Variable.Type);
	}
	const bool bBuffer = Variable.Storage == EStorage::Member || Variable.Storage == EStorage::Loose;
	if (bBuffer && !Variable.bWritten)
	{
		return BufferPlace(Variable);
	}
	const bool bShared = Variable.Storage == EStorage::Groupshared;
	if (bBuffer || bShared || Variable.Storage == EStorage::Static)
	{
		uint32_t& Id = Globals[&Variable];
		if (Id == 0)
		{
			Id = Module.Global(TypeOf(Variable.Type), bShared ? StorageWorkgroup : StoragePrivate, Variable.Name);
		}
		return Local(Id, Variable.Type, bShared ? StorageWorkgroup : StoragePrivate);
	}
	uint32_t& Id = Frame->Locals[&Variable];
	if (Id == 0)
	{
		Id = Temporary(TypeOf(Variable.Type), Variable.Name);
	}
	return Local(Id, Variable.Type);
}

FTarget FEmitter::BufferPlace(const FVariable& Variable)
{
	FTarget Target = Local(BufferOf(*Variable.Buffer), Variable.Type, StorageUniform);
	uint32_t Index = 0;
	for (uint32_t i = 0; i < Variable.Index; ++i)
	{
		Index += CountScalars(Variable.Buffer->Members[i]->Type) > 0 ? 1 : 0;
	}
	Target.Chain = {Module.Int(int32_t(Index))};
	Target.Layout = ELayout::Constants;
	return Target;
}

/** The whole of a ConstantBuffer. */
FTarget FEmitter::BlockPlace(const FValue& Node)
{
	FTarget Target;
	Target.Type = Node.Type->Element;
	Target.Objects = Object(Node);
	Target.Storage = StorageUniform;
	Target.Layout = ELayout::Constants;
	return Target;
}

FTarget FEmitter::ElementPlace(const FValue& Node)
{
	const FType* const Of = Node.Operands[0]->Type;
	FTarget Target;
	Target.Type = Node.Type;
	Target.Objects = Object(*Node.Operands[0]);
	const uint32_t Index = Value(*Node.Operands[1]);
	if (IsStructured(Of->Object) || IsWideBuffer(Of))
	{
		Target.Storage = StorageUniform;
		Target.Layout = ELayout::Structured;
		Target.Chain = {Module.Int(0), Index};
		return Target;
	}
	Target.Kind = FTarget::EKind::Texel;
	Target.At = Index;
	Target.Level = Node.Operands.size() > 2 ? Value(*Node.Operands[2]) : 0;
	return Target;
}

/** One step further into an array, a struct or a matrix. */
FTarget FEmitter::At(FTarget Target, uint32_t Index, const FType* Type)
{
	const FType* const Of = Target.Type;
	if (Of->IsMatrix() && Target.Layout && IsTurned(Of))
	{
		FTarget Row;
		Row.Kind = FTarget::EKind::Scalars;
		Row.Type = Type;
		for (uint32_t c = 0; c < Of->Columns; ++c)
		{
			FTarget Scalar = Target;
			Scalar.Type = Types.Scalar(Of->Scalar);
			Scalar.Chain.push_back(Module.Int(int32_t(c)));
			if (Of->Rows > 1)
			{
				Scalar.Chain.push_back(Index);
			}
			Row.Scalars.push_back(std::move(Scalar));
		}
		return Row;
	}
	Target.Type = Type;
	Target.Chain.push_back(Index);
	return Target;
}

/** A component of a vector. */
FTarget FEmitter::Component(FTarget Target, uint32_t Index)
{
	const uint32_t Count = Target.Parts.empty() ? Target.Type->Columns : uint32_t(Target.Parts.size());
	uint32_t Known = 0;
	const bool bKnown = Module.FindNumber(Index, Known);
	if (Count == 1)
	{
		return Target;
	}
	if (bKnown && !Target.Parts.empty())
	{
		Index = Module.Int(Target.Parts[std::min(Known, Count - 1)]);
		Target.Parts.clear();
	}
	if (Target.Kind == FTarget::EKind::Pointer && Target.Parts.empty())
	{
		if (Target.Type->Columns > 1)
		{
			Target.Chain.push_back(Index);
		}
		Target.Type = Types.Scalar(Target.Type->Scalar);
		return Target;
	}
	if (bKnown && Target.Kind == FTarget::EKind::Scalars)
	{
		Module.FindNumber(Index, Known);
		return Target.Scalars[std::min<size_t>(Known, Target.Scalars.size() - 1)];
	}
	if (bKnown)
	{
		Module.FindNumber(Index, Known);
		Target.Parts = {uint8_t(std::min(Known, uint32_t(Target.Type->Columns) - 1))};
		return Target;
	}
	Target.Component = Index;
	return Target;
}

FTarget FEmitter::IndexPlace(const FValue& Node)
{
	FTarget Target = Place(*Node.Operands[0]);
	const FType* const Of = Node.Operands[0]->Type;
	const uint32_t Index = Value(*Node.Operands[1]);
	return Of->IsNumeric() && !Of->IsMatrix() ? Component(std::move(Target), Index)
											  : At(std::move(Target), Index, Node.Type);
}

FTarget FEmitter::MatrixPlace(const FTarget& Matrix, const std::vector<uint8_t>& Parts)
{
	const FType* const Of = Matrix.Type;
	const bool bTurned = Matrix.Layout && IsTurned(Of);
	FTarget Result;
	Result.Kind = FTarget::EKind::Scalars;
	Result.Type = Types.Vector(Of->Scalar, uint32_t(Parts.size()));
	for (const uint8_t Part : Parts)
	{
		FTarget Scalar = Matrix;
		Scalar.Type = Types.Scalar(Of->Scalar);
		const int32_t Row = Part / 4;
		const int32_t Column = Part % 4;
		Scalar.Chain.push_back(Module.Int(bTurned ? Column : Row));
		if ((bTurned ? Of->Rows : Of->Columns) > 1)
		{
			Scalar.Chain.push_back(Module.Int(bTurned ? Row : Column));
		}
		Result.Scalars.push_back(std::move(Scalar));
	}
	return Parts.size() == 1 ? Result.Scalars[0] : Result;
}

uint32_t FEmitter::PointerTo(const FTarget& Target, uint32_t Base, uint32_t Storage)
{
	if (Target.Chain.empty())
	{
		return Base;
	}
	const uint32_t Type = Target.Layout ? MemoryType(Target.Type, *Target.Layout) : TypeOf(Target.Type);
	FWords Words = {Base};
	Words.insert(Words.end(), Target.Chain.begin(), Target.Chain.end());
	return Op(OpAccessChain, Module.Pointer(Storage, Type), Words);
}

uint32_t FEmitter::LoadWhole(const FTarget& Target)
{
	if (Target.Kind == FTarget::EKind::Scalars)
	{
		FWords Scalars;
		for (const FTarget& Scalar : Target.Scalars)
		{
			Scalars.push_back(Load(Scalar));
		}
		return Scalars.size() == 1 ? Scalars[0] : Construct(TypeOf(Target.Type), Scalars);
	}
	if (Target.Kind == FTarget::EKind::Texel)
	{
		return ForEach(Target.Objects, TypeOf(Target.Type), [&](FLeaf& Leaf) { return ReadTexel(Target, Leaf); });
	}
	const bool bBlock = Target.Layout == ELayout::Constants && !Target.Objects.Leaves.empty() && Target.Chain.empty();
	if (bBlock) // a ConstantBuffer's block is a type of its own
	{
		FWords Members;
		for (const FMember& Member : Target.Type->Struct->Members)
		{
			if (CountScalars(Member.Type) > 0)
			{
				Members.push_back(Load(At(Target, Module.Int(int32_t(Members.size())), Member.Type)));
			}
		}
		return Construct(TypeOf(Target.Type), Members);
	}
	const uint32_t Type = Target.Layout ? MemoryType(Target.Type, *Target.Layout) : TypeOf(Target.Type);
	const auto LoadFrom = [&](uint32_t Base)
	{
		return Op(OpLoad, Type, {PointerTo(Target, Base, Target.Storage)});
	};
	const uint32_t Id = Target.Base ? LoadFrom(Target.Base)
									: ForEach(Target.Objects, Type, [&](FLeaf& Leaf) { return LoadFrom(IdOf(Leaf)); });
	return Target.Layout ? FromMemory(Id, Target.Type, *Target.Layout) : Id;
}

uint32_t FEmitter::Load(const FTarget& Target)
{
	uint32_t Id = LoadWhole(Target);
	uint32_t Count = Target.Type->Columns;
	if (!Target.Parts.empty())
	{
		Id = Shuffle(Id, Target.Type->Scalar, Count, Target.Parts);
		Count = uint32_t(Target.Parts.size());
	}
	if (Target.Bits.Count)
	{
		return BitsOf(Id, Target.Bits);
	}
	return Target.Component && Count > 1
			   ? Op(OpVectorExtractDynamic, ScalarType(Target.Type->Scalar), {Id, Target.Component})
			   : Id;
}

void FEmitter::Store(const FTarget& Target, uint32_t Id)
{
	if (Target.Bits.Count)
	{
		StoreBits(Target, Id);
		return;
	}
	if (Target.Component)
	{
		FTarget Vector = Target;
		Vector.Component = 0;
		const uint32_t Old = Load(Vector);
		const uint32_t Count = Target.Parts.empty() ? Target.Type->Columns : uint32_t(Target.Parts.size());
		Store(Vector, Op(OpVectorInsertDynamic, VectorOf(Target.Type->Scalar, Count), {Old, Id, Target.Component}));
		return;
	}
	if (Target.Kind == FTarget::EKind::Texel)
	{
		StoreTexel(Target, Id);
		return;
	}
	if (!Target.Parts.empty() || Target.Kind == FTarget::EKind::Scalars)
	{
		const size_t Count = Target.Parts.empty() ? Target.Scalars.size() : Target.Parts.size();
		for (size_t i = 0; i < Count; ++i)
		{
			const uint8_t Part = Target.Parts.empty() ? uint8_t(i) : Target.Parts[i];
			FTarget Whole = Target;
			Whole.Parts.clear();
			const FTarget Scalar = Component(std::move(Whole), Module.Int(Part));
			Store(Scalar, Count == 1 ? Id : ExtractAt(Id, ScalarType(Target.Type->Scalar), {uint32_t(i)}));
		}
		return;
	}
	const uint32_t Written = Target.Layout ? ToMemory(Id, Target.Type, *Target.Layout) : Id;
	if (Target.Layout && !IsSameInMemory(Target.Type) && !Target.Type->IsNumeric())
	{
		StoreParts(Target, Id);
		return;
	}
	const auto StoreTo = [&](uint32_t Base)
	{
		Do(OpStore, {PointerTo(Target, Base, Target.Storage), Written});
		return 0u;
	};
	Target.Base ? StoreTo(Target.Base) : ForEach(Target.Objects, 0, [&](FLeaf& Leaf) { return StoreTo(IdOf(Leaf)); });
}

/** A struct or an array in a buffer, member by member. */
void FEmitter::StoreParts(const FTarget& Target, uint32_t Id)
{
	const FType* const Type = Target.Type;
	const uint32_t Count = Type->IsArray() ? Type->Count : uint32_t(Type->Struct->Members.size());
	for (uint32_t i = 0, Index = 0; i < Count; ++i)
	{
		const FType* const Part = Type->IsArray() ? Type->Element : Type->Struct->Members[i].Type;
		if (CountScalars(Part) > 0)
		{
			Store(At(Target, Module.Int(int32_t(Index)), Part), ExtractAt(Id, TypeOf(Part), {Index}));
			++Index;
		}
	}
}

void FEmitter::StoreTexel(const FTarget& Target, uint32_t Id)
{
	const FType* const Type = Target.Type;
	uint32_t Texel = Id;
	if (!Target.Parts.empty()) // read, changed and written
	{
		FTarget Whole = Target;
		Whole.Parts.clear();
		const uint32_t Old = Load(Whole);
		FWords Scalars;
		for (uint32_t c = 0; c < Type->Columns; ++c)
		{
			Scalars.push_back(Extract(Old, Type, c));
		}
		for (uint32_t i = 0; i < Target.Parts.size(); ++i)
		{
			Scalars[Target.Parts[i]] = Target.Parts.size() == 1 ? Id : ExtractAt(Id, ScalarType(Type->Scalar), {i});
		}
		Texel = Scalars.size() == 1 ? Scalars[0] : Construct(TypeOf(Type), Scalars);
	}
	const uint32_t Written = ConvertScalars(Texel, Type->Scalar, TexelScalar(Type->Scalar), Type->Columns);
	ForEach(Target.Objects, 0,
		[&](FLeaf& Leaf)
		{
			const uint32_t Image = Op(OpLoad, ImageType(Leaf.Type), {IdOf(Leaf)});
			Do(OpImageWrite, {Image, Target.At, Written});
			return 0u;
		});
}

uint32_t FEmitter::ReadTexel(const FTarget& Target, FLeaf& Leaf)
{
	const EObject Object = Leaf.Type->Object;
	const uint32_t Image = Op(OpLoad, ImageType(Leaf.Type), {IdOf(Leaf)});
	FWords Words = {Image, Target.At};
	if (!IsWritable(Object) && Object != EObject::Buffer)
	{
		Words.push_back(ImageLod);
		Words.push_back(Target.Level ? Target.Level : Module.Int(0));
	}
	const EScalar Scalar = TexelScalar(Leaf.Type->Element->Scalar);
	const uint32_t Texel = Op(IsWritable(Object) ? OpImageRead : OpImageFetch, VectorOf(Scalar, 4), Words);
	return CutTexel(Texel, Leaf.Type, Target.Type);
}

/** The texel's four components as what the resource holds. */
uint32_t FEmitter::CutTexel(uint32_t Id, const FType* Resource, const FType* To)
{
	const EScalar Scalar = TexelScalar(Resource->Element->Scalar);
	return Convert(Id, Types.Vector(Scalar, 4), To);
}

} // namespace Drydock::Hlsl
